// What held the object of a goal back, two links away from it, and that nothing unconfirmed is said.
#include "insight/why/runs/held_back.hpp"
#include "insight/why/words/words.hpp"
#include "puzzle/campaign/as_played.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace trembler::insight {
namespace held_back_tests {
namespace {

Answer answerOf(LevelFile level, std::string const& solution, int threads = 1) {
    Solution const chosen = solution.empty() ? Solution{} : *level.findSolution(solution);
    level = asPlayed(std::move(level), "");
    LevelRuns const runs(gameData(), level);
    AskOptions options;
    options.frames = 600;
    options.threads = threads;
    return why(runs, chosen, {}, options);
}

Answer answerIn(std::string const& file, std::string const& solution, int threads = 1) {
    return answerOf(loadLevel(gameData().registry, testedFile(file)), solution, threads);
}

Miss const* besideIn(Answer const& answer, Lack lack) {
    for (Miss const& miss : answer.nearest->nearest.besides) {
        if (miss.lack == lack) {
            return &miss;
        }
    }
    return nullptr;
}

/// The gate's level with a further object.
LevelFile gateWith(nlohmann::json const& object) {
    std::ifstream file(testedFile("5-everything/2-the-gate.json"));
    nlohmann::json all = nlohmann::json::parse(file);
    all["objects"].push_back(object);
    return readLevel(gameData().registry, JsonDocument::parse(all.dump(), "gate.json"));
}

nlohmann::json stone(double x, double height) {
    return {{"name", "post"},
            {"at", {x, height / 2}},
            {"properties",
             {{"material", "stone"},
              {"shape", {{{"form", "box"}, {"width", 0.1}, {"height", height}}}},
              {"fixed", true}}}};
}

TEST(HeldBack, TheGateIsNamedAndTheGapInTheCircuitOfItsMotor) {
    Answer const answer = answerIn("5-everything/2-the-gate.json", "wood is no wire");
    ASSERT_TRUE(answer.nearest);
    Miss const* const blocked = besideIn(answer, Lack::blocked);
    ASSERT_NE(blocked, nullptr);
    EXPECT_EQ(blocked->names, (std::vector<std::string>{"gate", "robot"}));
    Miss const* const gap = besideIn(answer, Lack::gap);
    ASSERT_NE(gap, nullptr);
    EXPECT_EQ(gap->names, std::vector<std::string>{"gate"});
    ASSERT_EQ(gap->gaps.size(), 1U);
    EXPECT_EQ(gap->gaps.front().nameA, "broken end");
    EXPECT_EQ(gap->gaps.front().nameB, "other broken end");
    EXPECT_EQ(gap->ifClosed, IfClosed::met) << "a recorded solution lays a wire there";
    Catalogue const german(gameData().home / "assets" / "text", "de");
    std::vector<std::string> const told = sentencesOf(answer, "", AnswerLanguage(german));
    ASSERT_EQ(told.size(), 5U);
    EXPECT_EQ(told[2], "Das Tor stand dem Roboter im Weg.");
    EXPECT_EQ(told[4], "Wäre dieser Stromkreis geschlossen gewesen, wäre das Ziel erreicht worden.");
    EXPECT_EQ(toJson(answer, "", "", AnswerLanguage())["nearest_miss"]["besides"][1]["if_closed"], "met");
}

// The generator is wired to the gate, and turns too slowly.
TEST(HeldBack, AGeneratorThatIsTooSlowIsNamed) {
    Answer const answer = answerIn("5-everything/2-the-gate.json", "nobody turns the crank");
    ASSERT_TRUE(answer.nearest);
    ASSERT_NE(besideIn(answer, Lack::blocked), nullptr);
    Miss const* const gap = besideIn(answer, Lack::gap);
    ASSERT_NE(gap, nullptr);
    EXPECT_EQ(gap->gaps.front().reason, GapReason::slow);
}

// A stone behind the gate: its motor could not open it either.
TEST(HeldBack, ADeviceThatWouldNotHaveHelpedIsNotNamed) {
    Answer const answer = answerOf(gateWith(stone(1.25, 1.2)), "wood is no wire");
    ASSERT_TRUE(answer.nearest);
    EXPECT_EQ(besideIn(answer, Lack::blocked), nullptr);
    EXPECT_EQ(besideIn(answer, Lack::gap), nullptr);
}

// A stone before the gate: the robot never touches the gate.
TEST(HeldBack, ABodyThatWasNotReachedIsNotNamed) {
    Answer const answer = answerOf(gateWith(stone(0.3, 1.2)), "wood is no wire");
    ASSERT_TRUE(answer.nearest);
    EXPECT_EQ(besideIn(answer, Lack::blocked), nullptr);
}

// The goal is about a cap that is welded to the gate.
TEST(HeldBack, AMotorOfTheGoalsOwnObjectIsNamed) {
    Answer const answer = answerIn("5-everything/3-the-quiet-gate.json", "");
    ASSERT_TRUE(answer.nearest);
    EXPECT_EQ(besideIn(answer, Lack::blocked), nullptr);
    Miss const* const gap = besideIn(answer, Lack::gap);
    ASSERT_NE(gap, nullptr);
    EXPECT_EQ(gap->names, std::vector<std::string>{"gate"});
    EXPECT_EQ(gap->ifClosed, IfClosed::nearer) << "the alarm would have had current, too";
}

// A level without motors and magnets.
TEST(HeldBack, NothingIsAddedWithoutDevices) {
    Answer const answer = answerIn("4-water/3-ferry.json", "");
    ASSERT_TRUE(answer.nearest);
    EXPECT_EQ(besideIn(answer, Lack::blocked), nullptr);
}

TEST(HeldBack, DoesNotDependOnThreads) {
    Answer const one = answerIn("5-everything/2-the-gate.json", "wood is no wire", 1);
    Answer const three = answerIn("5-everything/2-the-gate.json", "wood is no wire", 3);
    EXPECT_EQ(toJson(one, "", "", AnswerLanguage()), toJson(three, "", "", AnswerLanguage()));
}

} // namespace
} // namespace held_back_tests
} // namespace trembler::insight
