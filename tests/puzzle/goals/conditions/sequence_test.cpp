#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(SequenceCondition, HoldsOnlyIfTheStepsAreReachedInOrder) {
    char const* const goal = R"({"sequence": [{"on": "lamp"}, {"on": "lamp 2", "for": 0.05}]})";
    GoalStage right(goal);
    right.turn("lamp", true);
    right.step();
    EXPECT_TRUE(right.judge().status()[0].met);
    right.turn("lamp", false); // a reached step stays reached
    right.turn("lamp 2", true);
    right.step(2);
    EXPECT_FALSE(right.judge().solved());
    right.step();
    EXPECT_TRUE(right.judge().solved());

    GoalStage wrong(goal);
    wrong.turn("lamp 2", true);
    wrong.step(10);
    EXPECT_FALSE(wrong.judge().status()[1].met);
    wrong.turn("lamp", true);
    wrong.step(10);
    EXPECT_TRUE(wrong.judge().status()[0].met);
    EXPECT_FALSE(wrong.judge().solved()); // it was lit before its step was due
    wrong.turn("lamp 2", false);
    wrong.step();
    wrong.turn("lamp 2", true);
    wrong.step(3);
    EXPECT_TRUE(wrong.judge().solved());
}

TEST(SequenceCondition, StaysReachedAndKeepsTheCausesOfItsSteps) {
    GoalStage stage(
        R"({"all": [{"sequence": [{"on": "lamp"}, {"on": "lamp 2"}]}, {"on": "electromagnet"}]})");
    stage.turn("lamp", true, 3);
    stage.step();
    EXPECT_DOUBLE_EQ(stage.judge().status()[0].progress, 0.5);
    stage.turn("lamp", false, 4);
    stage.turn("lamp 2", true, 5);
    stage.step();
    EXPECT_EQ(stage.met(), "10");
    stage.turn("lamp 2", false, 6);
    stage.step();
    EXPECT_EQ(stage.met(), "10") << "it stays reached";
    EXPECT_EQ(stage.judge().causes(stage.world(), 0), (std::vector<EventId>{{3}, {5}}));
}

TEST(SequenceCondition, ShowsProgressOfTheStepThatIsDue) {
    GoalStage stage(R"({"sequence": [{"moved": {"object": "crate", "by": 4}},
        {"moved": {"object": "metal object", "by": 4}}]})");
    stage.put("crate", {6, 0});
    stage.put("metal object", {2, 0});
    stage.step();
    ASSERT_EQ(stage.judge().status().size(), 2U) << "a goal for each step";
    EXPECT_DOUBLE_EQ(stage.judge().status()[0].progress, 0.25);
    EXPECT_EQ(stage.judge().status()[1].progress, 0) << "its step is not due yet";
    stage.put("crate", {9, 0});
    stage.step();
    EXPECT_EQ(stage.met(), "10");
    EXPECT_DOUBLE_EQ(stage.judge().status()[1].progress, 0.5);
}

TEST(SequenceCondition, IsReadOrRefusedAtItsPlace) {
    EXPECT_TRUE(isRefused(R"({"sequence": []})", "/goals/sequence: is empty"));
    EXPECT_TRUE(isRefused(R"({"sequence": "lamp"})", "a list of conditions"));
}

TEST(SequenceCondition, TextStatesTheStepsInOrder) {
    EXPECT_EQ(
        wordsOf(R"({"any": [{"sequence": [{"on": "lamp"}, {"off": "lamp"}]}, {"on": "electromagnet"}]})"),
        "Either first light the lamp, then put out the lamp, or switch on the electromagnet");
    EXPECT_EQ(wordsOf(R"({"sequence": [{"on": "lamp"}, {"off": "lamp"}], "for": 2})"),
              "First light the lamp, then put out the lamp, then wait for 2 seconds");
    EXPECT_EQ(wordsOf(R"({"not": {"sequence": [{"on": "lamp"}, {"off": "lamp"}]}})"),
              "Do not first light the lamp, then put out the lamp");
    EXPECT_EQ(wordsOf(R"({"not": {"sequence": [{"on": "lamp"}, {"off": "lamp"}], "for": 2}})"),
              "Do not first light the lamp, then put out the lamp for 2 seconds");
}

} // namespace
} // namespace trembler
