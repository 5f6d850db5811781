#include "puzzle/data/game_data.hpp"
#include "puzzle/goals/words/lamp.hpp"
#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(Lamp, IsAnElectricalDeviceMadeOfGlass) {
    GoalStage stage(R"({"on": "lamp"})");
    EXPECT_TRUE(isLamp(stage.world(), stage.id("lamp")));
    EXPECT_TRUE(isLamp(stage.world(), stage.id("lantern")));
    EXPECT_FALSE(isLamp(stage.world(), stage.id("toy lamp")));
    EXPECT_FALSE(isLamp(stage.world(), stage.id("electromagnet")));
    EXPECT_FALSE(isLamp(stage.world(), ObjectId{}));
}

TEST(Lamp, IsOnlyThePartLamp) {
    GameData const data;
    std::vector<std::string> lamps;
    for (PartDefinition const* const part : data.parts.all()) {
        if (isLamp(part->prototype())) {
            lamps.push_back(part->name);
        }
    }
    EXPECT_EQ(lamps, std::vector<std::string>{"lamp"});
}

} // namespace
} // namespace trembler
