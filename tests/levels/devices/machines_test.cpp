// Parts that move by electricity, or make it: motor, generator, doorbell, buzzer.
#include "tests/levels/devices/device_bench.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace trembler {
namespace {

using MachineParts = DeviceBench;

TEST_F(MachineParts, AMotorTurnsWhileItHasCurrent) {
    put("motor", "motor", {0, 1});
    put("battery", "battery", {2, 0.125});
    wire("battery plus", "motor left");
    wire("motor right", "battery minus");
    input(600, R"("cut": ["motor right", "battery minus"])");
    start();
    runTo(600);
    double const idle = 720 * std::numbers::pi / 180;
    EXPECT_NEAR(spin("motor wheel"), idle, 0.02 * idle);
    runTo(3600);
    EXPECT_LT(std::abs(spin("motor wheel")), 0.2 * idle); // only its bearing brakes it
}

TEST_F(MachineParts, AGeneratorLightsALampWhileItsCrankIsTurned) {
    put("generator", "generator", {0, 0.41});
    put("bulb", "bulb", {2, 0.3});
    wire("generator plus", "bulb left");
    wire("bulb right", "generator minus");
    input(60, R"("grab": "generator crank", "at": [0, 0.11])");
    for (int i = 1; i <= 60; ++i) {
        double const angle = 0.4 * i;
        input(60 + 6 * static_cast<std::uint64_t>(i),
              fmt::format(R"("move": [{}, {}])", 0.3 * std::sin(angle), 0.41 - 0.3 * std::cos(angle)));
    }
    input(430, R"("release": true)");
    start();
    EXPECT_EQ(framesOn("bulb", 60), 0);
    EXPECT_GT(framesOn("bulb", 420), 300);
    runTo(1200);
    EXPECT_EQ(framesOn("bulb", 1300), 0);
}

TEST_F(MachineParts, ADoorbellRingsAgainAndAgainUntilTheCurrentStops) {
    for (bool const flat : {false, true}) { // fed by mains, or by a battery
        put("bell", "doorbell", {0, 1.5});
        if (flat) {
            put("supply", "battery", {2, 0.125});
            wire("supply plus", "bell left");
            wire("bell right", "supply minus");
        } else {
            wire("plus", "bell left");
            wire("bell right", "minus");
        }
        input(600, R"("cut": ["bell left", "bell contact"])");
        start();
        std::vector<std::uint64_t> const rings = hits("bell striker", "bell bell", 600);
        ASSERT_GE(rings.size(), 20U);
        EXPECT_LT(relativeDeviation(intervals(rings)), 0.2);
        EXPECT_LE(hits("bell striker", "bell bell", 1200).size(), 2U);
    }
}

TEST_F(MachineParts, ADoorbellCanBeTakenApart) {
    for (std::string const piece : {"bell bell", "bell coil"}) {
        put("bell", "doorbell", {0, 1.5});
        wire("plus", "bell left");
        wire("bell right", "minus");
        input(300, "\"remove\": \"" + piece + "\"");
        start();
        EXPECT_GE(hits("bell striker", "bell bell", 300).size(), 8U);
        EXPECT_GE(hits("bell striker", "bell contact", 420).size(), 1U);
        std::size_t const beats = hits("bell striker", "bell contact", 900).size();
        if (piece == "bell bell") {
            EXPECT_GE(beats, 6U) << "without its bell it goes on interrupting its current, in wider swings";
        } else {
            EXPECT_LE(beats, 2U) << "nothing pulls the striker";
        }
    }
}

TEST_F(MachineParts, ABuzzerRattlesSeveralTimesASecond) {
    put("buzzer", "buzzer", {0, 1.5});
    wire("plus", "buzzer left");
    wire("buzzer right", "minus");
    start();
    runTo(60);
    double const rate = static_cast<double>(hits("buzzer tongue", "buzzer coil", 660).size()) / 10;
    EXPECT_GT(rate, 5);
    EXPECT_LT(rate, 20);
}

} // namespace
} // namespace trembler
