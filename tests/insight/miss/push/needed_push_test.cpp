#include "insight/miss/push/needed_push.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace trembler::insight {
namespace needed_push_test {
namespace {

/// A bar that hangs on a guide, and a fixed block of copper beside it.
std::unique_ptr<World> worldWith(std::string const& joints) {
    std::string const text = R"({"version": 2, "title": "Push", "text": "",
        "world": {"gravity": [0, -10], "bounds": [-2, -2, 4, 4]},
        "objects": [
            {"name": "bar", "at": [0, 0], "properties": {"mass": 2, "conductor": true,
                "shape": [{"form": "box", "width": 0.4, "height": 0.1}]}},
            {"name": "block", "at": [0, -0.2], "properties": {"fixed": true, "conductor": true,
                "shape": [{"form": "box", "width": 0.4, "height": 0.1}]}}],
        "joints": [)" + joints +
                             "]}";
    LevelFile const level = readLevel(gameData().registry, JsonDocument::parse(text, "push.json"));
    auto world = buildWorld(gameData().registry, level, gameData().parts);
    world->step(); // gravity's forces
    return world;
}

std::optional<NeededPush> pushIn(World const& world) {
    CircuitGap gap;
    gap.a = world.store().find("bar");
    gap.b = world.store().find("block");
    return neededPush(world, load::Neighbours(world), gap);
}

TEST(NeededPush, IsTheForceOfTheSpringAtTheEndOfTheWayLessTheWeight) {
    auto const world = worldWith(
        R"({"name": "guide", "form": "slider", "a": "bar", "at": [0, 0], "axis": [0, 1], "limited": true,
            "lower": -0.5, "upper": 0},
           {"name": "spring", "form": "spring", "a": "bar", "at": [0, 0], "at_b": [0, -0.5], "length": 0.6,
            "stiffness": 300})");
    auto const push = pushIn(*world);
    ASSERT_TRUE(push);
    // It moves down by 10 cm, until the spring has a length of 40 cm.
    EXPECT_NEAR(push->force, 300 * (0.6 - 0.4) - 2 * 10, 0.5);
    EXPECT_NEAR(push->direction.y, -1, 1e-9);
    EXPECT_EQ(push->turn, 0);
    EXPECT_FALSE(push->touched);
}

TEST(NeededPush, OfALeverIsItsTorqueByItsLength) {
    // A bar on a hinge at its left end, which a spring at its middle holds up.
    auto const world = worldWith(
        R"({"name": "hinge", "form": "hinge", "a": "bar", "at": [-0.2, 0]},
           {"name": "spring", "form": "spring", "a": "bar", "at": [0, 0], "at_b": [0, 1], "length": 0.9,
            "stiffness": 200})");
    auto const push = pushIn(*world);
    ASSERT_TRUE(push);
    EXPECT_LT(push->direction.y, 0);
    EXPECT_GT(push->turn, 0.1);
    // The corner at 0.4 m is 0.1 m lower at the end; the spring is longer by half of that, and a little
    // slanted.
    double const angle = push->turn;
    Vec2 const middle = Vec2{-0.2, 0} + 0.2 * Vec2{std::cos(angle), -std::sin(angle)};
    double const now = length(Vec2{0, 1} - middle);
    EXPECT_NEAR(push->force, 200 * (now - 0.9) - 2 * 10, 2);
}

TEST(NeededPush, IsNothingForWhatHangsFreely) {
    EXPECT_FALSE(pushIn(*worldWith(R"({"name": "rope", "form": "rope", "a": "bar", "at": [0, 0],
        "at_b": [0, 1]})")));
    // Nor where the guide leads past the other end.
    EXPECT_FALSE(pushIn(*worldWith(R"({"name": "guide", "form": "slider", "a": "bar", "at": [0, 0],
        "axis": [1, 0]})")));
}

} // namespace
} // namespace needed_push_test
} // namespace trembler::insight
