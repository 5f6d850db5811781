#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(OnCondition, HoldsWhileOneOfItsObjectsIsPartOfAWorkingCircuit) {
    GoalStage stage(R"({"all": [{"on": "lamp"}, {"on": ["lamp", "lamp 2"]}]})");
    stage.step();
    EXPECT_EQ(stage.met(), "00");
    stage.turn("lamp 2", true);
    stage.step();
    EXPECT_EQ(stage.met(), "01");
    stage.turn("lamp 2", false);
    stage.step();
    EXPECT_EQ(stage.met(), "00");
    stage.turn("lamp", true);
    stage.step();
    EXPECT_EQ(stage.met(), "11");
}

TEST(OnCondition, IsCausedByTheObjectsThatAreOn) {
    GoalStage stage(R"({"on": ["lamp", "lamp 2"]})");
    stage.turn("lamp", false, 3);
    stage.turn("lamp 2", true, 4);
    stage.step();
    EXPECT_EQ(stage.judge().causes(stage.world()), (std::vector<EventId>{{4}}));
}

TEST(OnCondition, IsReadOrRefusedAtItsPlace) {
    EXPECT_TRUE(isRefused(R"({"on": 3})", "/goals/on: is 3"));
    EXPECT_TRUE(isRefused(R"({"on": "crate"})", "/goals/on: 'crate' is no conductor, so it is never on"));
    EXPECT_TRUE(isRefused(R"({"on": ["lamp", "crate"]})", "'crate' is no conductor"));
}

TEST(OnCondition, TextLightsLampsAndSwitchesOnOtherObjects) {
    EXPECT_EQ(wordsOf(R"({"on": "lamp"})"), "Light the lamp");
    EXPECT_EQ(wordsOf(R"({"on": "lamp", "for": 3})"), "Keep the lamp lit for 3 seconds");
    EXPECT_EQ(wordsOf(R"({"not": {"on": "lamp"}})"), "Keep the lamp dark");
    EXPECT_EQ(wordsOf(R"({"on": "electromagnet"})"), "Switch on the electromagnet");
    EXPECT_EQ(wordsOf(R"({"on": ["lamp", "electromagnet"]})"), "Switch on the lamp or the electromagnet");
    EXPECT_EQ(wordsOf(R"({"not": {"on": "electromagnet"}})"), "Keep the electromagnet off");
}

} // namespace
} // namespace trembler
