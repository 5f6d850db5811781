#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(OffCondition, HoldsWhileOneOfItsExistingObjectsIsOff) {
    GoalStage stage(R"({"all": [{"off": "lamp"}, {"off": ["lamp", "lamp 2"]}, {"on": "electromagnet"}]})");
    stage.step();
    EXPECT_EQ(stage.met(), "110");
    stage.turn("lamp", true);
    stage.step();
    EXPECT_EQ(stage.met(), "010");
    stage.turn("lamp 2", true);
    stage.step();
    EXPECT_EQ(stage.met(), "000");
    stage.world().store().destroy({stage.id("lamp 2")});
    stage.step();
    EXPECT_EQ(stage.met(), "000") << "a removed object is neither on nor off";
}

TEST(OffCondition, IsCausedByTheObjectThatWentOff) {
    GoalStage stage(R"({"sequence": [{"on": "lamp"}, {"off": ["lamp", "lamp 2"]}]})");
    stage.turn("lamp", true, 3);
    stage.turn("lamp 2", true, 4);
    stage.step();
    stage.turn("lamp 2", false, 5);
    stage.step();
    EXPECT_EQ(stage.judge().causes(stage.world()), (std::vector<EventId>{{3}, {5}}));
}

TEST(OffCondition, IsReadOrRefusedAtItsPlace) {
    EXPECT_TRUE(isRefused(R"({"off": {}})", "/goals/off: 'part' is missing"));
    EXPECT_TRUE(isRefused(R"({"off": "crate"})", "/goals/off: 'crate' is no conductor, so it is never on"));
}

TEST(OffCondition, TextPutsOutLampsAndSwitchesOffOtherObjects) {
    EXPECT_EQ(wordsOf(R"({"off": "lamp"})"), "Put out the lamp");
    EXPECT_EQ(wordsOf(R"({"not": {"off": "lamp"}})"), "Keep the lamp lit");
    EXPECT_EQ(wordsOf(R"({"off": "electromagnet"})"), "Switch off the electromagnet");
    EXPECT_EQ(wordsOf(R"({"off": "electromagnet", "for": 1})"), "Keep the electromagnet off for 1 second");
}

} // namespace
} // namespace trembler
