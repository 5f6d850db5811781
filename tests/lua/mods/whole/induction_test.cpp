// Mods that make objects sources: coils in a moving field, and metal detectors.
#include "physics/dynamics/properties/body.hpp"
#include "physics/electricity/properties/quantities.hpp"
#include "physics/magnetism/properties.hpp"
#include "tests/lua/support/bundled_mods.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler::lua {
namespace {

ElectricalQuantities::Entry quantitiesAt(World const& world, std::string const& name) {
    auto const* const quantities = world.find<ElectricalQuantities>();
    auto const* const entry = quantities == nullptr ? nullptr : quantities->find(world.store().find(name));
    return entry == nullptr ? ElectricalQuantities::Entry{} : *entry;
}

constexpr double poleStrength = 200000; // A m
constexpr double coilWire = 100;        // m
constexpr double poleConstant = 1e-7;

// The law: the voltage is n l (v x B), with the field of each pole. A coil without a load has it as its
// potential, a frame after the motion that induces it.
double inducedVoltage(Vec2 coil, Vec2 velocity, std::vector<std::pair<Vec2, double>> const& poles) {
    double voltage = 0;
    for (auto const& [at, sign] : poles) {
        Vec2 const away = coil - at;
        double const square = dot(away, away) + magneticSoftening * magneticSoftening;
        Vec2 const field = away * (poleConstant * sign * poleStrength / (square * std::sqrt(square)));
        voltage += coilWire * (velocity.x * field.y - velocity.y * field.x);
    }
    return voltage;
}

TEST(InductionMod, AMovingCoilHasTheVoltageOfTheLaw) {
    auto const game = gameWith({"induction"});
    auto const world = worldOf(*game, R"(
        {"name": "coil", "part": "coil", "at": [-3, 0.4], "properties": {"fixed": false, "velocity": [4, 0.25]}},
        {"name": "minus", "part": "battery −", "at": [0, -30]},
        {"name": "magnet", "part": "bar magnet", "at": [0, 0], "angle_deg": 30, "properties": {"fixed": true,
          "magnetic_poles": {"poles": "both", "north": [0.35, 0], "south": [-0.35, 0]},
          "magnetic_strength": {"strength": 200000}}})");
    Vec2 const north{0.35 * std::cos(std::acos(-1) / 6), 0.35 * 0.5};
    double greatest = 0;
    for (int frame = 0; frame < 90; ++frame) {
        Vec2 const at = of<Position>(*world, "coil").value;
        Vec2 const velocity = of<Velocity>(*world, "coil").value;
        world->step();
        double const expected = inducedVoltage(at, velocity, {{north, 1}, {-1 * north, -1}});
        double const found = quantitiesAt(*world, "coil").potential;
        if (frame > 1) {
            ASSERT_NEAR(found, expected, 1e-6 * (1 + std::abs(expected))) << frame;
        }
        greatest = std::max(greatest, std::abs(found));
    }
    EXPECT_EQ(errorsOf(*game), "");
    EXPECT_GT(greatest, 1) << "V: there is something to be compared";
}

TEST(InductionMod, OnlyMotionBetweenTheTwoInduces) {
    auto const game = gameWith({"induction"});
    for (char const* const velocity : {"[0, 0]", "[2, -1]"}) {
        auto const world = worldOf(*game, fmt::format(R"(
            {{"name": "coil", "part": "coil", "at": [0, 0], "properties": {{"fixed": false, "velocity": {0}}}}},
            {{"name": "minus", "part": "battery −", "at": [0, -30]}},
            {{"name": "magnet", "at": [0, 1.5], "properties": {{"magnet": true, "velocity": {0}, "magnetic_poles": {{"poles": "north", "north": [0, 0]}},
              "magnetic_strength": {{"strength": 200000}}, "shape": [{{"form": "circle", "radius": 0.1}}]}}}})",
                                                      velocity));
        stepFrames(*world, 30);
        EXPECT_EQ(errorsOf(*game), "");
        EXPECT_NEAR(quantitiesAt(*world, "coil").potential, 0, 1e-4) << velocity;
    }
}

// The energy of the circuit is the loss of the motion.
TEST(InductionMod, TheCurrentTakesItsEnergyFromTheMotion) {
    auto const game = gameWith({"induction"});
    auto const world = worldOf(*game, R"(
        {"name": "coil", "part": "coil", "at": [0, 0]},
        {"name": "lamp", "part": "lamp", "at": [9, 9], "properties": {"resistance": 2}},
        {"name": "minus", "part": "battery −", "at": [9, 12]},
        {"name": "magnet", "at": [-4, 0.6], "properties": {"magnet": true, "velocity": [6, 0], "density": 500,
          "magnetic_poles": {"poles": "north", "north": [0, 0]}, "magnetic_strength": {"strength": 200000},
          "shape": [{"form": "circle", "radius": 0.2}]}})",
                               "[0, 0]", R"(["coil", "lamp"], ["lamp", "minus"])");
    auto const motion = [&] {
        Vec2 const v = of<Velocity>(*world, "magnet").value;
        return 0.5 * of<Mass>(*world, "magnet").value * dot(v, v);
    };
    world->step();
    double const before = motion();
    double supplied = 0;
    for (int frame = 0; frame < 120; ++frame) {
        world->step();
        supplied += quantitiesAt(*world, "coil").supplied * frameDuration;
    }
    EXPECT_EQ(errorsOf(*game), "");
    EXPECT_GT(supplied, 0.02 * before) << "J: there is something to be compared";
    EXPECT_NEAR(before - motion(), supplied, 0.05 * supplied);
}

// The sixth power of the distance, summed over all objects that are near.
TEST(MetalDetectorMod, VoltageFallsWithTheSixthPowerOfTheDistance) {
    auto const game = gameWith({"metal-detector"});
    auto const world = worldOf(*game, R"(
        {"name": "detector", "part": "metal detector", "at": [0, 0], "properties": {"scripts": [{"script": "Electricity <- Metal",
          "set": [{"param": "voltage", "number": 10}, {"param": "nominal", "number": 0.5}, {"param": "reach", "number": 3}]}]}},
        {"name": "ball", "part": "steel ball", "at": [-4, 0.6], "properties": {"velocity": [3, 0]}},
        {"name": "minus", "part": "battery −", "at": [0, -30]},
        {"name": "bar", "part": "copper bar", "at": [0, -1]},
        {"name": "wood", "part": "wooden ball", "at": [0, 0.5]},
        {"name": "wall", "part": "copper contact", "at": [0.7, -0.5]})");
    auto const share = [](double distance) {
        return distance > 3 ? 0 : std::pow(0.5 / std::max(distance, 0.5), 6);
    };
    for (int frame = 0; frame < 150; ++frame) {
        double const distance = length(of<Position>(*world, "ball").value);
        world->step();
        if (frame > 1) {
            double const expected = 10 * (share(distance) + share(1));
            ASSERT_NEAR(quantitiesAt(*world, "detector").potential, expected, 1e-9 * (1 + expected)) << frame;
        }
    }
    EXPECT_EQ(errorsOf(*game), "");
}

} // namespace
} // namespace trembler::lua
