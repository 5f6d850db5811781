#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(AnyCondition, IsOneGoalThatHoldsWhileOneOfThemDoes) {
    GoalStage stage(R"({"any": [{"on": "lamp"}, {"moved": {"object": "crate", "by": 4}},
        {"moved": {"object": "metal object", "by": 4}}]})");
    ASSERT_EQ(stage.judge().status().size(), 1U);
    stage.step();
    EXPECT_EQ(stage.judge().status()[0].progress, 0);
    stage.put("crate", {6, 0});
    stage.put("metal object", {3, 0});
    stage.step();
    EXPECT_DOUBLE_EQ(stage.judge().status()[0].progress, 0.75) << "the greatest progress of them";
    stage.turn("lamp", true, 3);
    stage.touch("crate", "floor", 4);
    stage.step();
    EXPECT_TRUE(stage.judge().solved());
    EXPECT_EQ(stage.judge().causes(stage.world()), (std::vector<EventId>{{3}}))
        << "only the conditions that hold are causes";
}

TEST(AnyCondition, IsReadOrRefusedAtItsPlace) {
    EXPECT_TRUE(isRefused(R"({"any": []})", "/goals/any: is empty"));
    EXPECT_TRUE(isRefused(R"({"any": [3]})", "/goals/any/0: is 3"));
}

TEST(AnyCondition, TextNamesTheAlternatives) {
    EXPECT_EQ(wordsOf(R"({"any": [{"on": "lamp"}, {"on": "electromagnet"}]})"),
              "Either light the lamp or switch on the electromagnet");
    EXPECT_EQ(wordsOf(R"({"any": [{"on": "lamp"}, {"on": "electromagnet"}], "for": 2})"),
              "Either keep the lamp lit or keep the electromagnet on, either of it for 2 seconds");
    EXPECT_EQ(wordsOf(R"({"any": [{"on": "lamp"}]})"), "Light the lamp");
    EXPECT_EQ(wordsOf(R"({"not": {"any": [{"on": "lamp"}, {"on": "electromagnet"}]}})"),
              "Keep the lamp dark and keep the electromagnet off");
    EXPECT_EQ(wordsOf(R"({"any": [{"on": "lamp", "text": "Make light."}, {"on": "electromagnet"}]})"),
              "Either make light or switch on the electromagnet");
}

} // namespace
} // namespace trembler
