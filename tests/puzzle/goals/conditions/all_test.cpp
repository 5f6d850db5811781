#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(AllCondition, IsAGoalForEachOfItsConditions) {
    GoalStage stage(R"({"all": [{"on": "lamp", "id": "light"}, {"not": {"touching": ["crate", "floor"]}}]})");
    ASSERT_EQ(stage.judge().status().size(), 2U);
    EXPECT_EQ(stage.judge().status()[0].id, "light");
    EXPECT_EQ(stage.judge().status()[1].id, "goal 2");
    EXPECT_EQ(stage.judge().status()[1].text, "Keep the crate away from the floor");
    for (char const* const whole : {R"({"all": [{"on": "lamp"}, {"on": "lamp 2"}], "for": 1})",
                                    R"({"all": [{"on": "lamp"}, {"on": "lamp 2"}], "text": "Make light"})"}) {
        EXPECT_EQ(GoalStage(whole).judge().status().size(), 1U) << whole;
    }
}

TEST(AllCondition, HoldsWhileAllOfThemHoldAtTheSameTime) {
    GoalStage stage(R"({"all": [{"on": "lamp"}, {"on": "lamp 2"}, {"moved": {"object": "crate", "by": 2}}],
        "text": "All at once"})");
    stage.turn("lamp", true);
    stage.put("crate", {6, 0});
    stage.step();
    EXPECT_NEAR(stage.judge().status()[0].progress, (1 + 0 + 0.5) / 3, 1e-15);
    stage.turn("lamp", false);
    stage.turn("lamp 2", true);
    stage.put("crate", {8, 0});
    stage.step();
    EXPECT_FALSE(stage.judge().solved()) << "each has held, but not at the same time";
    stage.turn("lamp", true, 3);
    stage.step();
    EXPECT_TRUE(stage.judge().solved());
    EXPECT_EQ(stage.judge().causes(stage.world()), (std::vector<EventId>{{3}}));
}

// What holds from the start is no progress: half of the bar was full before anything was done.
TEST(AllCondition, CountsOnlyTimeIfItMustLast) {
    GoalStage stage(R"({"all": [{"off": "lamp"}, {"on": "lamp 2"}], "for": 0.1})");
    stage.step();
    EXPECT_EQ(stage.judge().status()[0].progress, 0);
    stage.turn("lamp 2", true);
    stage.step(3);
    EXPECT_DOUBLE_EQ(stage.judge().status()[0].progress, 0.5);
    stage.turn("lamp 2", false);
    stage.step();
    EXPECT_EQ(stage.judge().status()[0].progress, 0) << "it must last without a break";
}

TEST(AllCondition, IsReadOrRefusedAtItsPlace) {
    EXPECT_TRUE(isRefused(R"({"all": []})", "/goals/all: is empty"));
    EXPECT_TRUE(isRefused(R"({"all": {"on": "lamp"}})", "a list of conditions"));
    EXPECT_TRUE(isRefused(R"({"all": [{"on": "lamp"}, {"on": "lmap"}]})", "/goals/all/1/on:"));
}

TEST(AllCondition, TextNamesEachCondition) {
    EXPECT_EQ(wordsOf(R"({"all": [{"on": "lamp"}, {"on": "electromagnet"}], "for": 2})"),
              "Keep the lamp lit and keep the electromagnet on, both for 2 seconds");
    EXPECT_EQ(wordsOf(R"({"all": [{"on": "lamp"}, {"on": "electromagnet"}, {"off": "lamp 2"}], "for": 2})"),
              "Keep the lamp lit, keep the electromagnet on and keep lamp 2 off, all of it for 2 seconds");
    EXPECT_EQ(wordsOf(R"({"all": [{"on": "lamp"}], "for": 2})"), "Keep the lamp lit for 2 seconds");
    EXPECT_EQ(wordsOf(R"({"not": {"all": [{"on": "lamp"}, {"on": "electromagnet"}]}})"),
              "Either keep the lamp dark or keep the electromagnet off");
    EXPECT_EQ(
        wordsOf(R"({"any": [{"all": [{"on": "lamp"}, {"on": "electromagnet"}]}, {"on": "lamp 2"},
                          {"not": {"off": "lamp"}}]})"),
        "Either light the lamp and switch on the electromagnet; switch on lamp 2, or keep the lamp lit");
}

} // namespace
} // namespace trembler
