#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(NegationCondition, HoldsWhileItsConditionDoesNot) {
    GoalStage stage(R"({"all": [{"not": {"on": "lamp"}}, {"not": {"on": "lamp", "for": 0.05}},
        {"on": "lamp 2"}]})");
    stage.turn("lamp", true);
    stage.step();
    EXPECT_EQ(stage.met(), "010") << "it has been on for less than three frames";
    stage.step(2);
    EXPECT_EQ(stage.met(), "000");
    stage.turn("lamp", false);
    stage.step();
    EXPECT_EQ(stage.met(), "110");
}

TEST(NegationCondition, IsCausedByTheEventsThatMakeItsConditionFalse) {
    GoalStage stage(R"({"not": {"any": [{"on": "lamp"}, {"not": {"on": "lamp 2"}}]}})");
    stage.turn("lamp", false, 3);
    stage.turn("lamp 2", true, 4);
    stage.step();
    EXPECT_TRUE(stage.judge().solved());
    EXPECT_EQ(stage.judge().causes(stage.world()), (std::vector<EventId>{{3}, {4}}));
}

TEST(NegationCondition, IsReadOrRefusedAtItsPlace) {
    EXPECT_TRUE(isRefused(R"({"not": [{"on": "lamp"}]})", "/goals/not: is a list of 1"));
    EXPECT_TRUE(isRefused(R"({"not": {"not": {"on": "lmap"}}})", "/goals/not/not/on:"));
}

TEST(NegationCondition, TextStatesTheOpposite) {
    EXPECT_EQ(wordsOf(R"({"not": {"not": {"on": "lamp"}}})"), "Light the lamp");
    EXPECT_EQ(wordsOf(R"({"not": {"on": "lamp"}, "for": 2})"), "Keep the lamp dark for 2 seconds");
    EXPECT_EQ(wordsOf(R"({"not": {"on": "lamp", "for": 2}})"), "Do not keep the lamp lit for 2 seconds");
}

} // namespace
} // namespace trembler
