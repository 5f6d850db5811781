// Mods that connect conductors: a Tesla coil, humid air and hot air.
#include "physics/dynamics/properties/body.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "tests/lua/support/bundled_mods.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace trembler::lua {
namespace {

bool isLit(World const& world, std::string const& name) {
    auto const* const state = world.find<ElectricalState>();
    return state != nullptr && state->isOn(world.store().find(name));
}

std::string callersBetween(World const& world, std::string const& a, std::string const& b) {
    return connectionBetween(world.store(), world.store().find(a), world.store().find(b)).names();
}

// The spark lasts for its share of every period, to the frame; the lamp is lit for the same time.
TEST(TeslaCoilMod, SparksForItsPartOfEveryPeriod) {
    auto const game = gameWith({"tesla-coil"});
    auto const world =
        worldOf(*game, R"(
        {"name": "plus", "part": "battery +", "at": [0, -9]}, {"name": "minus", "part": "battery −", "at": [1, -9]},
        {"name": "coil", "part": "tesla coil", "at": [0, 0], "properties": {"fixed": true, "scripts": [
          {"script": "Electricity <- Discharge", "set": [{"param": "period", "number": 1.5}, {"param": "spark", "number": 0.4}]}]}},
        {"name": "ball", "part": "steel ball", "at": [0.5, 0]},
        {"name": "lamp", "part": "lamp", "at": [3, -9]})",
                "[0, 0]", R"(["plus", "coil"], ["coil", "minus"], ["ball", "lamp"], ["lamp", "minus"])");
    while (!isLit(*world, "lamp")) {
        world->step();
        ASSERT_LT(world->time(), 1);
    }
    for (int period = 0; period < 4; ++period) {
        for (int frame = 0; frame < 90; ++frame) {
            ASSERT_EQ(isLit(*world, "lamp"), frame < 24) << "period " << period << ", frame " << frame;
            world->step();
        }
    }
    EXPECT_EQ(errorsOf(*game), "");
}

TEST(TeslaCoilMod, ASparkBeginsWithinItsReachAndEndsAtTheCutoff) {
    auto const game = gameWith({"tesla-coil"});
    auto const world = worldOf(*game, R"(
        {"name": "plus", "part": "battery +", "at": [0, -9]}, {"name": "minus", "part": "battery −", "at": [1, -9]},
        {"name": "coil", "part": "tesla coil", "at": [0, 0], "properties": {"fixed": true, "scripts": [
          {"script": "Electricity <- Discharge", "set": [{"param": "period", "number": 60}, {"param": "spark", "number": 60},
            {"param": "reach", "number": 1}, {"param": "cutoff", "number": 1.5}]}]}},
        {"name": "ball", "part": "steel ball", "at": [0, 2], "properties": {"velocity": [0, -0.88]}})",
                               "[0, 0.3]", R"(["plus", "coil"], ["coil", "minus"])");
    double begun = 0;
    double ended = 0;
    for (int frame = 0; frame < 60 * 12; ++frame) { // it turns back at 0.7 m
        bool const before = !callersBetween(*world, "coil", "ball").empty();
        world->step();
        bool const after = !callersBetween(*world, "coil", "ball").empty();
        double const distance = length(of<Position>(*world, "ball").value);
        begun = !before && after ? distance : begun;
        ended = before && !after ? distance : ended;
    }
    EXPECT_EQ(errorsOf(*game), "");
    EXPECT_NEAR(begun, 1, 0.02) << "at 0.4 m/s, and two frames late";
    EXPECT_NEAR(ended, 1.5, 0.03) << "at 0.7 m/s";
}

constexpr char const* airGap = R"(
    {"name": "left", "part": "wire end", "at": [-0.3, 0.35]}, {"name": "right", "part": "wire end", "at": [0.3, 0.35]},
    {"name": "plus", "part": "battery +", "at": [-9, 0]}, {"name": "minus", "part": "battery −", "at": [9, 0]},
    {"name": "lamp", "part": "lamp", "at": [9, 3], "properties": {"rated": {"power": 24, "voltage": 12}}},
    {"name": "heater", "part": "heater", "at": [1, -1], "properties": {"fixed": true}},
    {"name": "sponge", "part": "wet sponge", "at": [0, 0.121]})";
constexpr char const* airGapWires =
    R"(["plus", "left"], ["right", "lamp"], ["lamp", "minus"], ["heater", "minus"])";

std::string trayWith(std::string const& settings) {
    return fmt::format(
        R"({{"name": "tray", "part": "air tray", "at": [0, 0], "properties": {{"scripts": [{}]}}}})",
        settings);
}

double timeUntilLit(World& world, double most) {
    while (!isLit(world, "lamp") && world.time() < most) {
        world.step();
    }
    return world.time();
}

// A value that approaches F with the time constant T passes the share s of F after -T ln(1 - s).
TEST(HumidAirMod, ConductsAfterTheTimeThatItTakesToBecomeHumid) {
    auto const game = gameWith({"humid-air"});
    for (double const share : {0.3, 0.8, 0.95}) {
        auto const world = worldOf(
            *game,
            std::string(airGap) + ", " +
                trayWith(fmt::format(
                    R"({{"script": "Electricity <- Humid air", "set": [{{"param": "time", "number": 2}}, {{"param": "conducts", "number": {}}}]}})",
                    share)),
            "[0, -9.81]", airGapWires);
        EXPECT_NEAR(timeUntilLit(*world, 20), -2 * std::log(1 - share), 0.15) << "and it has to fall down";
        EXPECT_EQ(callersBetween(*world, "left", "right"), "Electricity <- Humid air");
    }
    EXPECT_EQ(errorsOf(*game), "");
}

// Newton's law of cooling: C dT/dt = P - G T; P is that of the heater, 600 W at 12 V.
TEST(HumidAirMod, ConductsAfterTheTimeThatItTakesToBecomeHot) {
    auto const game = gameWith({"humid-air"});
    for (double const hot : {100.0, 250.0, 550.0}) {
        auto const world = worldOf(
            *game,
            std::string(airGap) + ", " +
                trayWith(fmt::format(
                    R"({{"script": "Electricity <- Hot air", "set": [{{"param": "loss", "number": 1}}, {{"param": "capacity", "number": 2}}, {{"param": "conducts", "number": {}}}]}})",
                    hot)),
            "[0, -9.81]", std::string(airGapWires) + R"(, ["plus", "heater"])");
        EXPECT_NEAR(timeUntilLit(*world, 20), -2.0 / 1 * std::log(1 - hot * 1 / 600), 0.06);
        EXPECT_EQ(callersBetween(*world, "left", "right"), "Electricity <- Hot air");
    }
    EXPECT_EQ(errorsOf(*game), "");
}

// 5.7.2: one connection with two causes. Each is counted separately, and while one remains the connection
// stays.
TEST(HumidAirMod, TwoCausesOfOneConnectionEndOneByOne) {
    auto const game = gameWith({"humid-air"});
    auto const world = worldOf(
        *game,
        std::string(airGap) + ", " +
            trayWith(R"({"script": "Electricity <- Humid air"}, {"script": "Electricity <- Hot air"})"),
        "[0, -9.81]", std::string(airGapWires) + R"(, ["plus", "heater"])",
        {.threads = 1, .detail = {}, .periods = {}, .trace = true});
    stepFrames(*world, 60 * 5);
    EXPECT_EQ(callersBetween(*world, "left", "right"), "Electricity <- Hot air, Electricity <- Humid air");
    world->feed(PlayerInput{
        .kind = PlayerInput::Kind::remove, .object = world->store().find("sponge"), .other = {}, .at = {}});
    for (int frame = 0; frame < 60 * 3; ++frame) {
        world->step();
        ASSERT_TRUE(isLit(*world, "lamp")) << frame;
    }
    EXPECT_EQ(callersBetween(*world, "left", "right"), "Electricity <- Hot air") << "it has dried";
    auto const disconnected = [&] {
        auto const& events = world->tracer()->events();
        return std::any_of(events.begin(), events.end(), [](Event const& event) {
            return event.event == "disconnected" &&
                   event.objects == std::vector<std::string>{"left", "right"};
        });
    };
    EXPECT_FALSE(disconnected());
    world->feed(PlayerInput{.kind = PlayerInput::Kind::cut,
                            .object = world->store().find("plus"),
                            .other = world->store().find("heater"),
                            .at = {}});
    stepFrames(*world, 60 * 5);
    EXPECT_FALSE(isLit(*world, "lamp")) << "it has cooled down, too";
    EXPECT_EQ(callersBetween(*world, "left", "right"), "");
    EXPECT_EQ(errorsOf(*game), "");
}

} // namespace
} // namespace trembler::lua
