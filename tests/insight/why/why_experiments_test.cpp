// The thesis's four experiments, and possible actions of a player in them: the answer's chain is that of the
// thesis's accounts (docs/account.md).
#include "insight/why/words/words.hpp"
#include "puzzle/campaign/as_played.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/trace/tracer.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace trembler::insight {
namespace why_experiments {
namespace {

LevelFile experiment(std::string const& name) {
    return loadLevel(gameData().registry, gameData().home / "levels/experiments" / (name + ".json"));
}

Answer answerIn(std::string const& name, std::string const& solution, Question const& question = {},
                std::uint64_t frames = 0) {
    LevelFile const level = experiment(name);
    LevelRuns const runs(gameData(), level);
    Solution const& asked = *level.findSolution(solution);
    AskOptions options;
    options.frames = frames > 0 ? frames : LevelRuns::framesFor(asked);
    return why(runs, asked, question, options);
}

Question ofObject(std::string const& object, double at) {
    Question question;
    question.object = object;
    question.at = at;
    return question;
}

/// The place of a step with all these objects; the chain's length if there is none.
std::size_t placeIn(Answer const& answer, StepKind kind, std::vector<std::string> const& objects) {
    auto const at = std::find_if(answer.chain.begin(), answer.chain.end(), [&](ChainStep const& one) {
        return one.step.kind == kind && std::all_of(objects.begin(), objects.end(), [&](auto const& name) {
                   auto const& all = one.step.objects;
                   return std::find(all.begin(), all.end(), name) != all.end();
               });
    });
    return static_cast<std::size_t>(at - answer.chain.begin());
}

bool isSure(Answer const& answer, std::size_t place) {
    return place < answer.chain.size() &&
           (answer.chain[place].proof == Proof::confirmed || answer.chain[place].proof == Proof::together);
}

std::string told(Answer const& answer) {
    std::string all;
    for (std::string const& sentence : sentencesOf(answer, answer.goal, AnswerLanguage())) {
        all += sentence + " ";
    }
    return all;
}

void expectEarlierCauses(Answer const& answer) {
    for (std::size_t i = 0; i < answer.chain.size(); ++i) {
        for (std::size_t const cause : answer.chain[i].step.because) {
            ASSERT_LT(cause, i);
            EXPECT_LE(answer.chain[cause].step.frame, answer.chain[i].step.frame);
        }
    }
}

/// All of these steps are in the answer and proven, none later than the next.
void expectInOrder(Answer const& answer,
                   std::vector<std::pair<StepKind, std::vector<std::string>>> const& account) {
    expectEarlierCauses(answer);
    std::uint64_t before = 0;
    for (auto const& [kind, objects] : account) {
        std::size_t const place = placeIn(answer, kind, objects);
        ASSERT_LT(place, answer.chain.size()) << objects.front() << ": " << told(answer);
        EXPECT_TRUE(isSure(answer, place)) << objects.front();
        EXPECT_GE(answer.chain[place].step.frame, before) << objects.front();
        before = answer.chain[place].step.frame;
    }
}

// A spanner or a steel bar takes the place of the switch in the account, and was laid there.
TEST(WhyExperiments, AnotherBridgeIsNamedInPlaceOfTheSwitch) {
    for (std::string const bridge : {"spanner", "steel bar"}) {
        Answer const answer = answerIn("1-switched-electromagnet", "a " + bridge + " in its place");
        ASSERT_TRUE(answer.happened);
        expectInOrder(answer, {{StepKind::placed, {bridge + " 1"}},
                               {StepKind::contact, {bridge + " 1", "object 1"}},
                               {StepKind::on, {"electromagnet"}},
                               {StepKind::magnetOn, {"electromagnet"}},
                               {StepKind::pull, {"metal object"}},
                               {StepKind::contact, {"electromagnet", "metal object"}}});
        EXPECT_TRUE(isSure(answer, placeIn(answer, StepKind::contact, {bridge + " 1", "object 2"})));
        EXPECT_EQ(placeIn(answer, StepKind::contact, {"switch"}), answer.chain.size()) << told(answer);
    }
}

// `--event N` of `trembler why` is the N-th event of the trace.
TEST(WhyExperiments, AnEventIsExplainedByItsNumber) {
    LevelFile const level = experiment("1-switched-electromagnet");
    LevelRuns const runs(gameData(), level);
    Question question;
    std::uint64_t frame = 0;
    RunObserver observer;
    observer.end = [&](LevelRun const& run) {
        std::span<Event const> const events = run.world().tracer()->events();
        for (std::size_t i = 0; i < events.size() && !question.event; ++i) {
            if (kindOf(events[i]) == StepKind::magnetOn) {
                question.event = i + 1;
                frame = events[i].frame;
            }
        }
    };
    Solution const& solution = *level.findSolution("hands off");
    (void)runs.run({solution}, {.frames = 200, .trace = true}, observer);
    ASSERT_TRUE(question.event);
    AskOptions options;
    options.frames = 200;
    Answer const answer = why(runs, solution, question, options);
    ASSERT_TRUE(answer.happened);
    ASSERT_FALSE(answer.chain.empty());
    EXPECT_EQ(answer.chain.back().step.kind, StepKind::magnetOn);
    EXPECT_EQ(answer.chain.back().step.frame, frame);
    expectInOrder(answer, {{StepKind::contact, {"object 1", "switch"}},
                           {StepKind::on, {"electromagnet"}},
                           {StepKind::magnetOn, {"electromagnet"}}});
    EXPECT_EQ(placeIn(answer, StepKind::pull, {"metal object"}), answer.chain.size()) << "it comes later";
}

// Without a way for the current the ball stays where it is, and the answer names both things that are
// missing.
TEST(WhyExperiments, ACutWireIsWhyNothingIsLifted) {
    Answer const answer = answerIn("1-switched-electromagnet", "cut the wire before the switch falls");
    EXPECT_FALSE(answer.happened);
    ASSERT_TRUE(answer.nearest);
    EXPECT_EQ(answer.nearest->nearest.lack, Lack::distance);
    ASSERT_EQ(answer.nearest->nearest.besides.size(), 1U);
    Miss const& circuit = answer.nearest->nearest.besides.front();
    EXPECT_EQ(circuit.lack, Lack::gap);
    ASSERT_EQ(circuit.gaps.size(), 1U);
    EXPECT_EQ(circuit.gaps.front().reason, GapReason::cut);
    std::string const words = told(answer);
    EXPECT_NE(words.find("No current flowed through the electromagnet: the wire between "), std::string::npos)
        << words;
    EXPECT_NE(words.find(" had been cut"), std::string::npos) << words;
    EXPECT_EQ(words.find("and the switch"), std::string::npos) << "the switch fell onto both: " << words;
}

TEST(WhyExperiments, TheDynamosLampIsLitBecauseOfTheSwitch) {
    Answer const answer = answerIn("3d-motor-and-generator", "hands off");
    ASSERT_TRUE(answer.happened);
    expectInOrder(answer, {{StepKind::contact, {"object 1", "switch"}},
                           {StepKind::on, {"motor"}},
                           {StepKind::on, {"lamp"}},
                           {StepKind::goal, {"lamp"}}});
}

// The lamp's own circuit is whole: its dynamo stands still.
TEST(WhyExperiments, ACutWireInTheMotorsCircuitIsNoGapInTheDynamos) {
    Answer const answer = answerIn("3d-motor-and-generator", "cut the wire before the switch falls");
    EXPECT_FALSE(answer.happened);
    std::string const words = told(answer);
    EXPECT_NE(words.find("the dynamo turned at 0 degrees a second"), std::string::npos) << words;
    EXPECT_EQ(words.find("between the dynamo and the motor"), std::string::npos) << words;
}

// Experiment II: the switch closes the circuit, the magnet pulls the striker, which leaves its contact.
TEST(WhyExperiments, TheDoorbellRingsBecauseOfItsSwitch) {
    Answer const answer = answerIn("2-doorbell", "a copper clip on the contact");
    ASSERT_TRUE(answer.happened);
    expectInOrder(answer, {{StepKind::contact, {"object 1", "switch"}},
                           {StepKind::on, {"electromagnet"}},
                           {StepKind::magnetOn, {"electromagnet"}},
                           {StepKind::pull, {"striker"}},
                           {StepKind::contact, {"bell", "striker"}}});
}

// "It leaves the contact, the current stops, and it falls back": the whole of each stroke.
TEST(WhyExperiments, TheStrikerFallsBackBecauseItsMagnetLetsGo) {
    Answer const answer = answerIn("2-doorbell", "hands off");
    ASSERT_TRUE(answer.happened);
    expectInOrder(answer, {{StepKind::contact, {"contact", "striker"}},
                           {StepKind::contact, {"object 1", "switch"}},
                           {StepKind::magnetOn, {"electromagnet"}},
                           {StepKind::pull, {"striker"}},
                           {StepKind::apart, {"contact", "striker"}},
                           {StepKind::off, {"electromagnet"}},
                           {StepKind::magnetOff, {"electromagnet"}},
                           {StepKind::contact, {"bell", "striker"}}});
    std::size_t fallsBack = answer.chain.size();
    for (std::size_t i = 0; i < answer.chain.size(); ++i) {
        Step const& step = answer.chain[i].step;
        bool const letsGo = std::any_of(step.because.begin(), step.because.end(), [&](std::size_t cause) {
            return answer.chain[cause].step.kind == StepKind::magnetOff;
        });
        if (letsGo) {
            EXPECT_EQ(step.kind, StepKind::contact) << told(answer);
            EXPECT_EQ(step.objects, (std::vector<std::string>{"contact", "striker"}))
                << "the striker reaches the bell by its momentum: " << told(answer);
            EXPECT_TRUE(isSure(answer, i));
            fallsBack = i;
        }
    }
    ASSERT_LT(fallsBack, answer.chain.size());
    ASSERT_LT(fallsBack + 1, answer.chain.size());
    EXPECT_EQ(answer.chain[fallsBack + 1].step.kind, StepKind::on) << "and so it goes on";
}

// Other programs rely on the keys.
TEST(WhyExperiments, TheJsonNamesWhatStoodInTheWayAndWhatWasCut) {
    auto const missIn = [](std::string const& level, std::string const& solution) {
        return toJson(answerIn(level, solution).nearest->nearest);
    };
    auto const wedge = missIn("2-doorbell", "a wedge in the way");
    EXPECT_EQ(wedge["what"], "distance");
    ASSERT_EQ(wedge["besides"].size(), 1U);
    EXPECT_EQ(wedge["besides"][0]["what"], "blocked");
    EXPECT_EQ(wedge["besides"][0]["objects"], nlohmann::ordered_json({"wooden wedge 1", "striker"}));
    EXPECT_EQ(wedge["besides"][0]["if_gone"], "met");
    auto const cut = missIn("1-switched-electromagnet", "cut the wire before the switch falls");
    ASSERT_EQ(cut["besides"].size(), 1U);
    nlohmann::ordered_json const& gap = cut["besides"][0];
    EXPECT_EQ(gap["what"], "gap");
    EXPECT_EQ(gap["if_closed"], "met");
    EXPECT_GT(gap["frame"], cut["frame"]) << "the best moment of the circuit";
    EXPECT_EQ(gap["gaps"][0]["reason"], "cut");
    EXPECT_EQ(gap["gaps"][0]["width"], 0);
}

// The circuit is closed again and again, so that no gap is missing: without the wedge the bell rings.
TEST(WhyExperiments, AWedgeIsWhyTheBellIsSilent) {
    Answer const answer = answerIn("2-doorbell", "a wedge in the way");
    EXPECT_FALSE(answer.happened);
    std::string const words = told(answer);
    EXPECT_NE(words.find("The striker came within"), std::string::npos) << words;
    EXPECT_EQ(words.find("No current flowed"), std::string::npos) << words;
    EXPECT_NE(words.find("Wooden wedge 1 stood in the way of the striker"), std::string::npos) << words;
    EXPECT_NE(words.find("Without wooden wedge 1, the goal would have been met"), std::string::npos) << words;
}

// The switch closes the other gap while the clip still insulates the contact.
TEST(WhyExperiments, AWoodenClipIsWhyNoCurrentFlows) {
    Answer const answer = answerIn("2-doorbell", "a wooden clip on the contact");
    EXPECT_FALSE(answer.happened);
    std::string const words = told(answer);
    EXPECT_NE(words.find("No current flowed through the electromagnet"), std::string::npos) << words;
    EXPECT_NE(words.find("between the contact and the striker"), std::string::npos) << words;
    EXPECT_EQ(words.find("object 1 and object 2"), std::string::npos) << words;
    EXPECT_EQ(words.find("and the switch"), std::string::npos) << words;
}

// Experiment III: "the sliding contact falls onto a spoke and closes a circuit through it", and opens it.
TEST(WhyExperiments, TheMotorsMagnetIsSwitchedByTheSlidingContact) {
    Answer const off = answerIn("3-electric-motor", "hands off", ofObject("upper electromagnet", 1), 120);
    ASSERT_TRUE(off.happened);
    expectInOrder(off, {{StepKind::contact, {"sliding contact", "spoke 1"}},
                        {StepKind::off, {"upper electromagnet"}},
                        {StepKind::magnetOff, {"upper electromagnet"}}});
}

// "Put the stone block where the spokes have to pass."
TEST(WhyExperiments, ABlockIsWhyTheMotorStops) {
    Answer const answer = answerIn("3-electric-motor", "a block in its way");
    EXPECT_FALSE(answer.happened);
    std::string const words = told(answer);
    EXPECT_NE(words.find("Block 1 stood in the way of spoke "), std::string::npos) << words;
    EXPECT_NE(words.find("Without block 1, the goal would have been met"), std::string::npos) << words;
}

// Experiment IV: the floats are in the water.
TEST(WhyExperiments, TheRaftsFloatsAreInTheWater) {
    for (std::string const object : {"flotation device A", "flotation device B"}) {
        Answer const answer = answerIn("4-raft", "hands off", ofObject(object, 3));
        ASSERT_TRUE(answer.happened);
        expectEarlierCauses(answer);
        EXPECT_LT(placeIn(answer, StepKind::liquid, {object, "water body"}), answer.chain.size())
            << told(answer);
    }
}

// "The ones above the raft will impact with it" and "they are buoyant enough to keep the raft and three cargo
// boxes afloat": also with two boxes more.
TEST(WhyExperiments, TheRaftBearsItsBoxesBecauseItsFloatsAreInTheWater) {
    for (std::string const solution : {"hands off", "a fourth and a fifth box"}) {
        Answer const answer = answerIn("4-raft", solution);
        ASSERT_TRUE(answer.happened) << solution;
        expectEarlierCauses(answer);
        for (std::string const object : {"flotation device A", "flotation device B"}) {
            std::size_t const dips = placeIn(answer, StepKind::liquid, {object, "water body"});
            EXPECT_TRUE(isSure(answer, dips)) << object << ": " << told(answer);
        }
        for (std::string const box : {"cargo 1", "cargo 2", "cargo 3"}) {
            std::size_t const falls = placeIn(answer, StepKind::contact, {box, "raft body"});
            EXPECT_LT(falls, answer.chain.size()) << box << ": " << told(answer);
        }
        EXPECT_EQ(answer.chain.back().step.kind, StepKind::goal);
        EXPECT_NE(told(answer).find("dips into the water body"), std::string::npos) << told(answer);
    }
}

// "If this is sufficient to cause the cargo to slide off": the goal held for a moment; the cause of its end
// follows from the objects in the water and on the raft, not from the time that was missing.
TEST(WhyExperiments, ALoadOnTheLeftEndIsWhyTheRaftGoesUnder) {
    Answer const answer = answerIn("4-raft", "load the left end");
    ASSERT_FALSE(answer.happened);
    ASSERT_TRUE(answer.nearest);
    std::string const words = told(answer);
    EXPECT_NE(words.find("The raft body was "), std::string::npos) << words;
    EXPECT_NE(words.find("The water body would have lifted the raft body there with "), std::string::npos)
        << words;
    EXPECT_NE(words.find("The load turned the raft body with "), std::string::npos) << words;
    EXPECT_NE(words.find(" m away from the raft body"), std::string::npos) << words;
    EXPECT_EQ(words.find("came within"), std::string::npos) << "all boxes had touched it: " << words;
    Miss const& sunk = answer.nearest->nearest.besides.front();
    ASSERT_EQ(sunk.besides.size(), 2U);
    EXPECT_EQ(sunk.besides.front().lack, Lack::lift);
    EXPECT_EQ(sunk.besides.back().lack, Lack::torque);
    for (std::string const part : {"cargo box 1", "cargo box 2", "cargo box 3", "iron ball 1"}) {
        std::vector<std::string> const& names = sunk.besides.back().names;
        EXPECT_EQ(std::count(names.begin(), names.end(), part), 1) << part;
    }
}

// The goal is met because of the boxes that were placed, and because of the floats.
TEST(WhyExperiments, TwoMoreBoxesAreOnDeckBecauseTheyWerePlacedThere) {
    LevelFile const level = asPlayed(experiment("4-raft"), "");
    LevelRuns const runs(gameData(), level);
    AskOptions options;
    options.frames = 600;
    Answer const answer = why(runs, *level.findSolution("a fourth and a fifth box"), {}, options);
    ASSERT_TRUE(answer.happened);
    expectEarlierCauses(answer);
    for (std::string const box : {"cargo box 1", "cargo box 2"}) {
        EXPECT_TRUE(isSure(answer, placeIn(answer, StepKind::placed, {box}))) << told(answer);
        EXPECT_LT(placeIn(answer, StepKind::contact, {box, "raft body"}), answer.chain.size()) << box;
    }
    EXPECT_TRUE(isSure(answer, placeIn(answer, StepKind::liquid, {"flotation device A"}))) << told(answer);
    EXPECT_EQ(placeIn(answer, StepKind::liquid, {"cargo 11"}), answer.chain.size())
        << "what lies on the ground carries nothing: " << told(answer);
}

} // namespace
} // namespace why_experiments
} // namespace trembler::insight
