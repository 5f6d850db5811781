// The switches among the parts: the objects that close and open them, and how precisely they must be placed.
#include "tests/levels/devices/device_bench.hpp"

namespace trembler {
namespace {

using SwitchParts = DeviceBench;

TEST_F(SwitchParts, APushSwitchIsClosedUntilTheWeightIsTakenAway) {
    for (SlightlyOff const& off : slightlyOff()) {
        put("switch", "push switch", {0, 1});
        weigh("weight", {0.05 + off.x, 1.4}, 1);
        wire("plus", "switch left");
        lampAfter("lamp", "switch right");
        input(180, R"("grab": "weight", "at": [0, 1.3])");
        input(181, R"("move": [0, 2.4])");
        start();
        runTo(180);
        EXPECT_TRUE(on("lamp")) << off.x;
        runTo(260);
        EXPECT_GT(at("weight").y, 2) << off.x;
        EXPECT_FALSE(on("lamp")) << off.x;
    }
}

TEST_F(SwitchParts, APushSwitchSpringsBackWhenTheHandLetsGo) {
    put("switch", "push switch", {0, 1});
    wire("plus", "switch left");
    lampAfter("lamp", "switch right");
    input(30, R"("grab": "switch button", "at": [0, 1.17])");
    input(31, R"("move": [0, 0.9])");
    input(120, R"("release": true)");
    start();
    runTo(30);
    EXPECT_FALSE(on("lamp"));
    double const atRest = at("switch button").y;
    runTo(120);
    EXPECT_TRUE(on("lamp"));
    runTo(200);
    EXPECT_FALSE(on("lamp"));
    EXPECT_NEAR(at("switch button").y, atRest, 2e-3);
}

// The spring is stretched by 0.23 m at rest, where it is 0.16 m long, and by the gap of 45 mm more when the
// bar of copper lies on both contacts: 40 N/m carry button, bar (0.7 kg) and 0.42 kg.
TEST_F(SwitchParts, APushSwitchClosesUnderTheWeightThatItsSpringCannotCarry) {
    double const carried = 40 * (0.39 - 0.16 + 0.045) / 9.81 - 0.7;
    for (double const share : {0.9, 1.1}) {
        put("switch", "push switch", {0, 1});
        weigh("weight", {0, 1.31}, share * carried);
        wire("plus", "switch left");
        lampAfter("lamp", "switch right");
        start();
        runTo(600);
        EXPECT_EQ(on("lamp"), share > 1) << share;
    }
}

TEST_F(SwitchParts, AToggleSwitchStaysWhereItWasPut) {
    put("switch", "toggle", {0, 1});
    wire("plus", "switch middle");
    lampAfter("left lamp", "switch left");
    lampAfter("right lamp", "switch right");
    input(120, R"("grab": "switch knob", "at": [-0.116, 1.269])");
    input(125, R"("move": [0.2, 1.3])");
    input(180, R"("release": true)");
    input(600, R"("grab": "switch knob", "at": [0.116, 1.269])");
    input(605, R"("move": [-0.2, 1.3])");
    input(660, R"("release": true)");
    start();
    runTo(10);
    for (std::uint64_t frame = 11; frame <= 120; ++frame) {
        step();
        ASSERT_TRUE(on("left lamp") && !on("right lamp")) << frame;
    }
    runTo(240);
    for (std::uint64_t frame = 241; frame <= 600; ++frame) {
        step();
        ASSERT_TRUE(!on("left lamp") && on("right lamp")) << frame;
    }
    runTo(1000);
    EXPECT_TRUE(on("left lamp") && !on("right lamp"));
    EXPECT_NEAR(angle("switch lever"), 20 * 3.14159 / 180, 0.03);
}

TEST_F(SwitchParts, APressurePlateTellsACrateFromARubberBall) {
    for (char const* thing : {"crate", "rubber ball", "wooden ball", "steel ball", ""}) {
        for (SlightlyOff const& off : slightlyOff()) {
            put("switch", "pressure plate", {0, 0.1});
            if (*thing != '\0') {
                put("thing", thing, {off.x, 0.52}, off.angleDeg);
            }
            wire("plus", "switch left");
            lampAfter("lamp", "switch right");
            start();
            runTo(400);
            bool const heavy = std::string(thing) == "crate" || std::string(thing) == "steel ball";
            EXPECT_EQ(on("lamp"), heavy) << thing << " " << off.x << " " << off.angleDeg;
        }
    }
}

} // namespace
} // namespace trembler
