// Parts that show measurements: compass and metronome.
#include "physics/dynamics/properties/shapes/mass_properties.hpp"
#include "tests/levels/devices/device_bench.hpp"

#include <cmath>
#include <numbers>

namespace trembler {
namespace {

using InstrumentParts = DeviceBench;

/// The field, up to a factor, of the small magnet's two poles.
Vec2 fieldOfTheSmallMagnet(Vec2 magnet, double angle, Vec2 at) {
    Vec2 sum;
    for (double const pole : {1.0, -1.0}) {
        Vec2 const r = at - (magnet + rotated(Vec2{0.17 * pole, 0}, angle));
        sum += pole / std::pow(length(r), 3) * r;
    }
    return sum;
}

TEST_F(InstrumentParts, ACompassTurnsAlongTheFieldOfAMagnet) {
    Vec2 const compass{0, 2};
    for (double const around : {0.3, 1.4, 2.5, 3.6, 4.7, 5.8}) {
        for (double const turned : {0.0, 60.0, 200.0}) {
            Vec2 const magnet = compass + 1.3 * Vec2{std::cos(around), std::sin(around)};
            put("compass", "compass", compass);
            put("magnet", "small magnet", magnet, turned, R"("properties": {"fixed": true})");
            start();
            runTo(900);
            Vec2 const field = fieldOfTheSmallMagnet(magnet, turned * std::numbers::pi / 180, compass);
            double const off =
                std::remainder(angle("compass needle") - std::atan2(field.y, field.x), 2 * std::numbers::pi);
            // The needle is not short, and the magnet is a little susceptible.
            EXPECT_LT(std::abs(off), 12 * std::numbers::pi / 180) << around << " " << turned;
        }
    }
}

/// The period of a pendulum that swings by `amplitude`, in rad.
double pendulumPeriod(MassProperties const& body, double gravity, double amplitude) {
    double const arm = length(body.centre);
    double const small =
        2 * std::numbers::pi * std::sqrt((body.inertiaPerMass + arm * arm) / (gravity * arm));
    double const a2 = amplitude * amplitude;
    return small * (1 + a2 / 16 + 11 * a2 * a2 / 3072);
}

TEST_F(InstrumentParts, AMetronomeTicksTwiceInThePeriodOfItsPendulum) {
    put("metronome", "metronome", {0, 1.5});
    start();
    MassProperties const body = massPropertiesOf(*world().find<Shape>(id("metronome pendulum")));
    double const amplitude = angle("metronome pendulum");
    runTo(10);
    std::vector<std::uint64_t> all = hits("metronome pendulum", "metronome tongue", 3600);
    std::vector<std::uint64_t> ticks; // the tongue may touch the pin twice as it is flicked
    for (std::uint64_t const frame : all) {
        if (ticks.empty() || frame > ticks.back() + 12) {
            ticks.push_back(frame);
        }
    }
    std::vector<double> const between = intervals(ticks);
    ASSERT_GE(between.size(), 60U);
    std::vector<double> const first(between.begin(), between.begin() + 12);
    double const expected = pendulumPeriod(body, 9.81, amplitude);
    EXPECT_NEAR(2 * mean(first) / 60, expected, 0.01 * expected);
    EXPECT_LT(relativeDeviation(between), 0.02);
}

} // namespace
} // namespace trembler
