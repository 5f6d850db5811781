// The chains of causes of the thesis's experiments and of levels are those of their accounts.
#include "insight/why/words/words.hpp"
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace trembler::insight {
namespace {

LevelFile whyLevel(std::string const& name) {
    return loadLevel(gameData().registry, gameData().home / "levels" / (name + ".json"));
}

Answer whyIn(std::string const& name, std::string const& solution, Question const& question = {},
             std::uint64_t frames = 900) {
    LevelFile const level = whyLevel(name);
    LevelRuns const runs(gameData(), level);
    AskOptions options;
    options.frames = frames;
    return why(runs, solution.empty() ? Solution{} : *level.findSolution(solution), question, options);
}

/// The place of a step in the chain; its length if there is none.
std::size_t placeOf(Answer const& answer, StepKind kind, std::vector<std::string> const& objects) {
    auto const at = std::find_if(answer.chain.begin(), answer.chain.end(), [&](ChainStep const& one) {
        return one.step.kind == kind && one.step.objects == objects;
    });
    return static_cast<std::size_t>(at - answer.chain.begin());
}

bool confirmedAt(Answer const& answer, std::size_t place) {
    return place < answer.chain.size() &&
           (answer.chain[place].proof == Proof::confirmed || answer.chain[place].proof == Proof::together);
}

/// No step comes before its causes, and every step but the last is a cause.
void expectSound(Answer const& answer) {
    std::vector<bool> named(answer.chain.size());
    for (std::size_t i = 0; i < answer.chain.size(); ++i) {
        for (std::size_t const cause : answer.chain[i].step.because) {
            ASSERT_LT(cause, i);
            EXPECT_LE(answer.chain[cause].step.frame, answer.chain[i].step.frame);
            named[cause] = true;
        }
    }
    for (std::size_t i = 0; i + 1 < named.size(); ++i) {
        EXPECT_TRUE(named[i]) << answer.chain[i].step.what;
    }
}

TEST(Why, ExperimentOneIsTheThesissAccount) {
    Answer const answer = whyIn("experiments/1-switched-electromagnet", "");
    ASSERT_TRUE(answer.happened);
    expectSound(answer);
    std::size_t const one = placeOf(answer, StepKind::contact, {"object 1", "switch"});
    std::size_t const two = placeOf(answer, StepKind::contact, {"object 2", "switch"});
    std::size_t const on = placeOf(answer, StepKind::on, {"electromagnet"});
    std::size_t const magnet = placeOf(answer, StepKind::magnetOn, {"electromagnet"});
    std::size_t const pull = placeOf(answer, StepKind::pull, {"metal object", "electromagnet"});
    for (std::size_t const place : {one, two, on, magnet, pull}) {
        EXPECT_TRUE(confirmedAt(answer, place)) << place;
    }
    EXPECT_LT(std::max(one, two), on);
    EXPECT_LT(on, magnet);
    EXPECT_LT(magnet, pull);
    EXPECT_EQ(answer.chain.back().step.kind, StepKind::goal);
    EXPECT_TRUE(answer.confirmed);
    // The floor and gravity are taken for granted.
    EXPECT_EQ(placeOf(answer, StepKind::contact, {"floor", "metal object"}), answer.chain.size());
}

TEST(Why, ThePartThatWasPlacedIsACause) {
    Answer const answer = whyIn("first/1-first-contact", "the spanner", {.goal = "current"});
    ASSERT_TRUE(answer.happened);
    expectSound(answer);
    EXPECT_TRUE(confirmedAt(answer, placeOf(answer, StepKind::placed, {"spanner 1"})));
    EXPECT_TRUE(confirmedAt(answer, placeOf(answer, StepKind::contact, {"left contact", "spanner 1"})));
    EXPECT_TRUE(confirmedAt(answer, placeOf(answer, StepKind::contact, {"right contact", "spanner 1"})));
    EXPECT_TRUE(answer.confirmed);
}

TEST(Why, TheDoorbellsRingsFollowFromItsContact) {
    Answer const answer = whyIn("experiments/2-doorbell", "", {}, 300);
    ASSERT_TRUE(answer.happened);
    expectSound(answer);
    EXPECT_TRUE(confirmedAt(answer, placeOf(answer, StepKind::contact, {"object 1", "switch"})));
    EXPECT_TRUE(confirmedAt(answer, placeOf(answer, StepKind::on, {"electromagnet"})));
    EXPECT_TRUE(confirmedAt(answer, placeOf(answer, StepKind::contact, {"contact", "striker"})));
}

TEST(Why, AGoalThatWasNotMetHasANearestMiss) {
    Answer const answer = whyIn("first/1-first-contact", "the wooden bar", {}, 300);
    EXPECT_FALSE(answer.happened);
    EXPECT_EQ(answer.goal, "current");
    ASSERT_TRUE(answer.nearest);
    EXPECT_EQ(answer.nearest->nearest.lack, Lack::gap);
    Catalogue const german(gameData().home / "assets" / "text", "de");
    std::string const english = sentencesOf(answer.nearest->nearest, AnswerLanguage()).front();
    EXPECT_NE(english.find("between the left contact and the right contact"), std::string::npos) << english;
    std::string const words = sentencesOf(answer.nearest->nearest, AnswerLanguage(german)).front();
    EXPECT_NE(words.find("zwischen dem linken Kontakt und dem rechten Kontakt"), std::string::npos) << words;
}

TEST(Why, AnObjectsStateHasAChain) {
    Question question;
    question.object = "electromagnet";
    question.at = 0.6;
    Answer const answer = whyIn("experiments/1-switched-electromagnet", "", question);
    ASSERT_TRUE(answer.happened);
    expectSound(answer);
    EXPECT_EQ(answer.chain.back().step.kind, StepKind::magnetOn);
}

TEST(Why, ABadQuestionNamesWhatThereIs) {
    Question question;
    question.goal = "lift";
    try {
        (void)whyIn("experiments/1-switched-electromagnet", "", question);
        FAIL();
    } catch (std::invalid_argument const& error) {
        EXPECT_NE(std::string(error.what()).find("lifted"), std::string::npos) << error.what();
    }
    question = {};
    question.object = "swich";
    try {
        (void)whyIn("experiments/1-switched-electromagnet", "", question);
        FAIL();
    } catch (std::invalid_argument const& error) {
        EXPECT_NE(std::string(error.what()).find("'switch'"), std::string::npos) << error.what();
    }
    question = {};
    question.event = 100000;
    EXPECT_THROW((void)whyIn("experiments/1-switched-electromagnet", "", question), std::invalid_argument);
}

TEST(Why, ItCanBeCancelled) {
    LevelRuns const runs(gameData(), whyLevel("experiments/2-doorbell"));
    AskOptions options;
    options.frames = 300;
    options.progress = [](std::size_t, std::size_t) { return false; };
    Answer const answer = why(runs, {}, {}, options);
    EXPECT_FALSE(answer.complete);
    EXPECT_LE(answer.runs, 2U);
}

TEST(Why, TheNumberOfThreadsDoesNotMatter) {
    for (auto const& [name, solution] : {std::pair{"first/1-first-contact", "the spanner"},
                                         {"experiments/2-doorbell", "hands off"},
                                         {"experiments/3-electric-motor", "hands off"}}) {
        LevelFile const level = whyLevel(name);
        LevelRuns const runs(gameData(), level);
        std::string first;
        for (int const threads : {1, 2, 8}) {
            AskOptions options;
            options.frames = 600;
            options.threads = threads;
            Answer const answer = why(runs, *level.findSolution(solution), {}, options);
            std::string const made = toJson(answer, "", "", AnswerLanguage()).dump();
            first = first.empty() ? made : first;
            EXPECT_EQ(made, first) << name << ", " << threads;
        }
    }
}

TEST(Why, ItEndsSoonWhenItIsToldTo) {
    LevelRuns const runs(gameData(), whyLevel("experiments/2-doorbell"));
    AskOptions options;
    options.frames = 300;
    int asked = 0;
    options.stop = [&] { return ++asked == 20; };
    Answer const answer = why(runs, {}, {}, options);
    EXPECT_FALSE(answer.complete);
    EXPECT_FALSE(answer.happened);
    EXPECT_TRUE(answer.chain.empty());
    EXPECT_EQ(asked, 20) << "a frame each";
}

TEST(Why, WhatWasSeenInAnUntracedRunCanBeAskedAbout) {
    Question question;
    question.sighted = SightedEvent{60, {"electromagnet"}, {StepKind::on, StepKind::magnetOn}};
    Answer const answer = whyIn("experiments/1-switched-electromagnet", "", question);
    ASSERT_TRUE(answer.happened);
    expectSound(answer);
    EXPECT_EQ(answer.chain.back().step.kind, StepKind::magnetOn);
    EXPECT_TRUE(confirmedAt(answer, placeOf(answer, StepKind::contact, {"object 1", "switch"})));
    question.sighted->objects = {"metal object"};
    EXPECT_THROW((void)whyIn("experiments/1-switched-electromagnet", "", question), NothingHappened);
}

// The balls also roll over a chute and a bridge, and into a bin on the floor.
TEST(Why, FloorsAndWallsAreToldOnlyIfAskedFor) {
    std::string const name = "3-magnets/2-steel-stays-here";
    LevelFile const level = whyLevel(name);
    LevelRuns const runs(gameData(), level);
    Solution const& solution = *level.findSolution("the magnet on the bridge");
    AskOptions options;
    options.frames = LevelRuns::framesFor(solution);
    auto const groundsIn = [&](Answer const& answer) {
        return std::count_if(answer.chain.begin(), answer.chain.end(), [&](ChainStep const& one) {
            return one.step.kind == StepKind::contact &&
                   std::any_of(
                       one.step.objects.begin(), one.step.objects.end(),
                       [&](std::string const& object) { return answer.facts.fixed.contains(object); });
        });
    };
    Answer const brief = why(runs, solution, {}, options);
    ASSERT_TRUE(brief.happened);
    EXPECT_EQ(groundsIn(brief), 0);
    EXPECT_TRUE(confirmedAt(brief, placeOf(brief, StepKind::placed, {"small magnet 1"})));
    EXPECT_TRUE(confirmedAt(brief, placeOf(brief, StepKind::pull, {"steel ball", "small magnet 1"})));
    options.everything = true;
    EXPECT_GT(groundsIn(why(runs, solution, {}, options)), 0);
}

// A bell that the goal names is fixed, too, and is no ground.
TEST(Why, WhatTheGoalNamesIsTold) {
    Answer const answer = whyIn("first/3-pass-it-on", "", {}, 1);
    EXPECT_FALSE(answer.happened);
    LevelFile const level = whyLevel("4-water/3-ferry");
    LevelRuns const runs(gameData(), level);
    Solution const& solution = *level.findSolution("a floating plank");
    AskOptions options;
    options.frames = LevelRuns::framesFor(solution);
    Answer const bell = why(runs, solution, {}, options);
    ASSERT_TRUE(bell.happened);
    EXPECT_LT(placeOf(bell, StepKind::contact, {"bell", "third domino"}), bell.chain.size());
}

// A balloon touches two contacts and so bypasses a lamp: neither touch is the cause of the other.
TEST(Why, AShortCircuitHasItsContactsSideBySide) {
    Answer const answer = whyIn("2-electricity/2-the-easy-way", "balloons from below", {.goal = "right"});
    ASSERT_TRUE(answer.happened);
    expectSound(answer);
    std::size_t const front = placeOf(answer, StepKind::contact, {"right front contact", "foil balloon 2"});
    std::size_t const back = placeOf(answer, StepKind::contact, {"right back contact", "foil balloon 2"});
    std::size_t const off = placeOf(answer, StepKind::off, {"right lamp"});
    ASSERT_LT(off, answer.chain.size());
    EXPECT_EQ(answer.chain[off].step.because, (std::vector{std::min(front, back), std::max(front, back)}));
}

// The place of each step, at its moment: a contact's lies on both objects as they are then, not as they were
// at the start.
TEST(Why, StepsHappenedWhereTheirObjectsWereThen) {
    Answer const answer = whyIn("experiments/1-switched-electromagnet", "");
    std::size_t const one = placeOf(answer, StepKind::contact, {"object 1", "switch"});
    ASSERT_LT(one, answer.chain.size());
    ChainStep const& step = answer.chain[one];
    Vec2 place;
    double gap = 1;
    RunObserver observer;
    LevelRuns const runs(gameData(), whyLevel("experiments/1-switched-electromagnet"));
    observer.end = [&](LevelRun const& run) {
        Store const& store = run.world().store();
        auto const shapeOf = [&](ObjectId id) {
            return PlacedShape{
                *run.world().find<Shape>(id), run.world().find<Position>(id)->value,
                run.world().find<Rotation>(id) == nullptr ? 0 : run.world().find<Rotation>(id)->angle};
        };
        ShapeGap const between = gapBetween(shapeOf(store.find("object 1")), shapeOf(store.find("switch")));
        gap = between.width;
        place = between.a;
    };
    (void)runs.run({}, {.frames = step.step.frame, .stopWhenSolved = false}, observer);
    EXPECT_LT(gap, 0.01);
    EXPECT_LT(length(step.at - place), 0.01);
    EXPECT_GT(length(step.at - answer.facts.places.at("switch")) +
                  length(step.at - answer.facts.places.at("object 1")),
              0.01);
}

std::vector<std::string> keysOf(nlohmann::ordered_json const& object) {
    std::vector<std::string> keys;
    for (auto const& [key, value] : object.items()) {
        keys.push_back(key);
    }
    return keys;
}

// All keys, as docs/why.md lists them: a new key is added there and here.
TEST(Why, TheJsonHasTheKeysThatOtherProgramsRelyOn) {
    using Keys = std::vector<std::string>;
    Answer const answer = whyIn("experiments/1-switched-electromagnet", "");
    nlohmann::ordered_json const made = toJson(answer, "goal lifted", "Lift it", AnswerLanguage());
    EXPECT_EQ(keysOf(made), (Keys{"asked", "happened", "answer", "confirmed", "chain", "dropped", "runs"}));
    for (auto const& step : made.at("chain")) {
        EXPECT_EQ(keysOf(step), (Keys{"frame", "event", "objects", "because", "confirmed", "proof", "traced",
                                      "times", "text"}));
    }
    Answer const missed = whyIn("first/1-first-contact", "", {}, 100);
    nlohmann::ordered_json const miss = toJson(missed, "", "", AnswerLanguage()).at("nearest_miss");
    EXPECT_EQ(keysOf(miss), (Keys{"frame", "what", "by", "unit", "measure", "objects", "gaps"}));
    EXPECT_EQ(keysOf(miss.at("gaps").at(0)), (Keys{"between", "width", "from", "to", "reason"}));
    std::ifstream in(gameData().home / "docs" / "why.md");
    std::string const page(std::istreambuf_iterator<char>(in), {});
    for (auto const* const one : {&made, &made.at("chain").at(0), &miss, &miss.at("gaps").at(0)}) {
        for (std::string const& key : keysOf(*one)) {
            EXPECT_NE(page.find('"' + key + '"'), std::string::npos) << key;
        }
    }
}

} // namespace
} // namespace trembler::insight
