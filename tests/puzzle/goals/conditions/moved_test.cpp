#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(MovedCondition, MeasuresFromTheInitialPlace) {
    struct Case {
        char const* towards;
        Vec2 way;        // m
        double progress; // of 2 m
    };
    for (Case const& c : {Case{"", {0.75, -1}, 0.625}, Case{"", {-3, 4}, 1}, Case{"up", {9, 1}, 0.5},
                          Case{"up", {0, -5}, 0}, Case{"down", {0, -1.5}, 0.75}, Case{"left", {-2, 7}, 1},
                          Case{"left", {2, 0}, 0}, Case{"right", {0.5, 0}, 0.25}}) {
        std::string const towards = *c.towards == 0 ? "" : R"(, "towards": ")" + std::string(c.towards) + '"';
        GoalStage stage(R"({"moved": {"object": "crate", "by": 2)" + towards + "}}");
        stage.put("crate", Vec2{5, 0} + c.way); // its initial place is (5, 0)
        stage.step();
        EXPECT_DOUBLE_EQ(stage.judge().status()[0].progress, c.progress) << c.towards;
        EXPECT_EQ(stage.judge().solved(), c.progress == 1) << c.towards;
    }
}

TEST(MovedCondition, UsesTheFarthestOfTheRemainingObjects) {
    GoalStage stage(R"({"moved": {"object": ["ball a", "ball b"], "by": 4}})");
    stage.put("ball a", {7, 1});
    stage.put("ball b", {8, 2});
    stage.step();
    EXPECT_DOUBLE_EQ(stage.judge().status()[0].progress, 0.5);
    stage.world().store().destroy({stage.id("ball b")});
    stage.step();
    EXPECT_DOUBLE_EQ(stage.judge().status()[0].progress, 0.25);
}

TEST(MovedCondition, IsCausedByTheContactsOfTheObject) {
    GoalStage stage(R"({"moved": {"object": "crate", "by": 1}})");
    stage.touch("crate", "object 1", 9);
    stage.put("crate", {6, 0});
    stage.step();
    EXPECT_EQ(stage.judge().causes(stage.world()), (std::vector<EventId>{{9}}));
}

TEST(MovedCondition, IsReadOrRefusedAtItsPlace) {
    EXPECT_TRUE(isRefused(R"({"moved": {"object": "crate"}})", "/goals/moved: 'by' is missing"));
    EXPECT_TRUE(isRefused(R"({"moved": {"object": "crate", "by": 0}})", "/goals/moved/by:"));
    EXPECT_TRUE(
        isRefused(R"({"moved": {"object": "crate", "by": 1, "towards": "upp"}})", "did you mean 'up'"));
    EXPECT_TRUE(isRefused(R"({"moved": {"object": "idea", "by": 1}})",
                          "'idea' is nowhere, so it can never get anywhere"));
}

TEST(MovedCondition, IsRefusedIfAllObjectsAreFixed) {
    EXPECT_TRUE(isRefused(R"({"moved": {"object": "floor", "by": 1}})",
                          "/goals: can never hold: a fixed object never moves"));
    EXPECT_TRUE(isRefused(R"({"moved": {"object": ["floor", "electromagnet"], "by": 1}})",
                          "a fixed object never moves"));
    EXPECT_EQ(refusalOf(R"({"moved": {"object": ["floor", "crate"], "by": 1}})"), "");
}

TEST(MovedCondition, TextStatesTheDirection) {
    EXPECT_EQ(wordsOf(R"({"moved": {"object": "crate", "by": 0.5}})"), "Move the crate by at least 0.5 m");
    EXPECT_EQ(wordsOf(R"({"moved": {"object": "crate", "by": 2, "towards": "up"}})"),
              "Lift the crate by at least 2 m");
    EXPECT_EQ(wordsOf(R"({"moved": {"object": "crate", "by": 2, "towards": "down"}})"),
              "Lower the crate by at least 2 m");
    EXPECT_EQ(wordsOf(R"({"moved": {"object": "crate", "by": 2, "towards": "right"}})"),
              "Move the crate to the right by at least 2 m");
    EXPECT_EQ(wordsOf(R"({"moved": {"object": "crate", "by": 2, "towards": "left"}, "for": 2})"),
              "Keep the crate at least 2 m to the left of where it was at the start for 2 seconds");
    EXPECT_EQ(
        wordsOf(R"({"count": {"of": ["crate", "object 1"], "at_least": 2,
                          "that": {"moved": {"object": "it", "by": 2}, "for": 2}}})"),
        "Keep both the crate and object 1 at least 2 m from where they were at the start for 2 seconds");
    EXPECT_EQ(wordsOf(R"({"not": {"moved": {"object": "crate", "by": 1}}})"),
              "Do not move the crate by 1 m or more");
}

} // namespace
} // namespace trembler
