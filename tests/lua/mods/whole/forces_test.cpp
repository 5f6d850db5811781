// Mods about forces at a distance, against the laws of motion: wind, anti-gravity, explosions.
#include "physics/dynamics/properties/body.hpp"
#include "tests/lua/support/bundled_mods.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler::lua {
namespace {

// m g = c (w - v)^2 for a box that has reached its final speed in a wind from below.
TEST(WindMod, ABoxInAnUpdraughtComesToItsTerminalSpeed) {
    auto const game = gameWith({"wind"});
    auto const world = worldOf(*game, R"(
        {"name": "fan", "at": [0, 0], "angle_deg": 90, "properties": {"fixed": true, "scripts": [{"script": "Dynamics <- Wind",
          "set": [{"param": "speed", "number": 10}, {"param": "reach", "number": 1000}]}]}},
        {"name": "box", "at": [0, 300], "properties": {"density": 10, "shape": [{"form": "box", "width": 1, "height": 1}]}})",
                               "[0, -9.81]");
    stepFrames(*world, 60 * 20);
    EXPECT_EQ(errorsOf(*game), "");
    double const c = 0.5 * 1.2 * 1.05 * 1 * 0.1; // kg/m: half density, drag coefficient, face
    double const mass = 10 * 1 * 0.1;
    EXPECT_NEAR(of<Velocity>(*world, "box").value.y, 10 - std::sqrt(mass * 9.81 / c), 0.01);
}

TEST(WindMod, TheConeEndsAtItsAngleAndItsReach) {
    auto const game = gameWith({"wind"});
    auto const box = [](std::string const& name, double distance, double angle) {
        return fmt::format(
            R"(, {{"name": "{}", "at": [{}, {}], "properties": {{"density": 10, "shape": [{{"form": "box", "width": 0.1, "height": 0.1}}]}}}})",
            name, distance * std::cos(angle), distance * std::sin(angle));
    };
    constexpr double degree = 3.14159265358979 / 180;
    auto const world = worldOf(
        *game, R"({"name": "fan", "at": [0, 0], "angle_deg": 0, "properties": {"fixed": true, "scripts": [
            {"script": "Dynamics <- Wind", "set": [{"param": "half_angle", "number": 30}, {"param": "reach", "number": 4}]}]}})" +
                   box("within", 3.9, 29.5 * degree) + box("aside", 3.9, 30.5 * degree) +
                   box("beyond", 4.1, 0) + box("behind", 1, 180 * degree));
    stepFrames(*world, 10);
    EXPECT_GT(of<Velocity>(*world, "within").value.x, 0);
    for (char const* const name : {"aside", "beyond", "behind"}) {
        EXPECT_EQ(of<Velocity>(*world, name).value.x, 0) << name;
    }
}

// A body that crosses a volume of width d at the speed v is in it for d/v, and there its weight is less.
TEST(WeightlessMod, DeflectsABodyByTheTimeThatItIsInTheVolume) {
    auto const game = gameWith({"weightless"});
    std::string const ball =
        R"({"name": "ball", "at": [-6, 0], "properties": {"material": "steel", "velocity": [10, 0],
            "shape": [{"form": "circle", "radius": 0.1}]}})";
    auto const without = worldOf(*game, ball, "[0, -0.1]");
    auto const with =
        worldOf(*game, ball + R"(, {"name": "device", "at": [0, 0], "properties": {"fixed": true,
                                "scripts": [{"script": "Dynamics <- Anti-gravity", "set": [
                                  {"param": "radius", "number": 4}, {"param": "share", "number": 0.5}]}]}})",
                "[0, -0.1]");
    stepFrames(*without, 90);
    stepFrames(*with, 90);
    EXPECT_EQ(errorsOf(*game), "");
    double const speed = of<Velocity>(*with, "ball").value.x;
    double const more = of<Velocity>(*with, "ball").value.y - of<Velocity>(*without, "ball").value.y;
    EXPECT_NEAR(more, 0.5 * 0.1 * 8 / speed, 1.5 * 0.5 * 0.1 / 60) << "to a frame";
}

// A body of width w takes w / (2 pi r) of the blast's momentum; one that touches the charge half of it.
TEST(ExplosionMod, ImpulsesFallWithTheDistance) {
    auto const game = gameWith({"explosion"});
    std::string objects = R"(
        {"name": "plus", "part": "battery +", "at": [0, -40]}, {"name": "minus", "part": "battery −", "at": [1, -40]},
        {"name": "charge", "at": [0, 0], "properties": {"conductor": true, "scripts": [
          {"script": "Dynamics <- Explosion", "set": [{"param": "momentum", "number": 500}, {"param": "reach", "number": 30}]},
          {"script": "Population <- Explosion"}]}})";
    struct Body {
        char const* name;
        Vec2 at;
        double width;
    };
    std::vector<Body> const bodies{{"near", {0.2, 0}, 1},  {"one", {-1, 0}, 0.2},  {"two", {0, 2}, 0.2},
                                   {"wide", {0, -3}, 0.8}, {"far", {12, 16}, 0.4}, {"beyond", {-31, 0}, 0.4}};
    for (Body const& body : bodies) {
        objects += fmt::format(
            R"(, {{"name": "{0}", "at": [{1}, {2}], "properties": {{"density": 100, "shape": [{{"form": "box", "width": {3}, "height": {3}}}]}}}})",
            body.name, body.at.x, body.at.y, body.width);
    }
    auto const world = worldOf(*game, objects, "[0, 0]", R"(["plus", "charge"], ["charge", "minus"])");
    stepFrames(*world, 6);
    EXPECT_EQ(errorsOf(*game), "");
    EXPECT_FALSE(world->store().find("charge").valid()) << "nothing is left of it";
    for (Body const& body : bodies) {
        double const distance = length(body.at);
        double const share = std::min(0.5, body.width / (2 * 3.14159265358979 * distance));
        double const mass = 100 * body.width * body.width * 0.1;
        Vec2 const expected = body.at * (distance > 30 ? 0 : 500 * share / (distance * mass));
        Vec2 const found = of<Velocity>(*world, body.name).value;
        EXPECT_NEAR(found.x, expected.x, 1e-4 * (1 + std::abs(expected.x))) << body.name;
        EXPECT_NEAR(found.y, expected.y, 1e-4 * (1 + std::abs(expected.y))) << body.name;
    }
}

} // namespace
} // namespace trembler::lua
