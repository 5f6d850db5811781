// Drops that come and go, counted.
#include "physics/dynamics/properties/body.hpp"
#include "tests/lua/support/bundled_mods.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler::lua {
namespace {

std::string tapOf(double rate, int most) {
    return fmt::format(
        R"({{"name": "tap", "at": [0, 10], "angle_deg": 0, "properties": {{"scripts": [{{"script": "Population <- Tap",
        "set": [{{"param": "rate", "number": {}}}, {{"param": "most", "number": {}}}]}}]}}}})",
        rate, most);
}

/// How many of the tap's first drops exist.
int dropsIn(World const& world, int ofFirst) {
    int there = 0;
    for (int number = 1; number <= ofFirst; ++number) {
        there += world.store().find(fmt::format("drop of tap {}", number)).valid() ? 1 : 0;
    }
    return there;
}

class TapRate : public testing::TestWithParam<double> {};

// An object that is requested in a frame exists in the next one.
TEST_P(TapRate, AfterATimeThereAreThatManyDrops) {
    double const rate = GetParam();
    auto const game = gameWith({"tap"});
    auto const world = worldOf(*game, tapOf(rate, 40), "[0, -9.81]");
    for (int frame = 1; frame <= 60 * 6; ++frame) {
        world->step();
        int const due = static_cast<int>(std::floor((frame - 1) / 60.0 * rate + 1e-6));
        ASSERT_EQ(dropsIn(*world, 60), std::min(due, 40)) << "frame " << frame;
    }
    EXPECT_EQ(errorsOf(*game), "");
}
INSTANTIATE_TEST_SUITE_P(Rates, TapRate, testing::Values(0.0, 0.7, 4.0, 10.0, 29.9));

TEST(TapMod, ADropLeavesTheMouthAndFallsFreely) {
    auto const game = gameWith({"tap"});
    auto const world = worldOf(*game, tapOf(4, 1), "[0, -9.81]");
    stepFrames(*world, 15 + 1); // requested after a quarter of a second
    double const born = of<Position>(*world, "drop of tap 1").value.y;
    EXPECT_NEAR(born, 10 - 0.3, 0.05);
    stepFrames(*world, 60);
    EXPECT_NEAR(of<Position>(*world, "drop of tap 1").value.y, born - 0.5 - 9.81 / 2, 0.3) << "v t + g t²/2";
    EXPECT_NEAR(of<Velocity>(*world, "drop of tap 1").value.y, -0.5 - 9.81 * 61 / 60, 0.2);
}

TEST(TapMod, WhatTheTapHasMadeTheDrainTakesAndNothingElse) {
    auto const game = gameWith({"tap"});
    auto const world = worldOf(*game, tapOf(10, 25) + R"(,
        {"name": "drain", "part": "drain", "at": [0, 7]},
        {"name": "ball", "part": "wooden ball", "at": [0.4, 7.5]})",
                               "[0, -9.81]");
    std::size_t most = 0;
    for (int frame = 0; frame < 60 * 4; ++frame) {
        world->step();
        most = std::max(most, static_cast<std::size_t>(dropsIn(*world, 25)));
    }
    EXPECT_EQ(errorsOf(*game), "");
    // Each falls 2.6 m, which takes 0.68 s, so there are about 7 at a time.
    EXPECT_GE(most, 5U);
    EXPECT_LE(most, 9U);
    EXPECT_EQ(dropsIn(*world, 25), 0);
    EXPECT_TRUE(world->store().find("ball").valid());
}

} // namespace
} // namespace trembler::lua
