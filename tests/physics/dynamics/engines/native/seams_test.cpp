// Flush tiles are one floor.
#include "tests/physics/dynamics/engines/native/small_world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler::test {
namespace native_seams_test {
namespace {

double unit() {
    return *rc::gen::inRange(0, 1000001) / 1e6;
}

void layTiles(SmallWorld& world, double width, double restitution = 0) {
    for (double x = -2; x < 30; x += width) {
        world.add(boxShape(width, 0.2), {.at = {x, -0.1}, .restitution = restitution, .fixed = true});
    }
}

TEST(NativeSeams, RollingBallsNeitherHopNorLoseSpeed) {
    EXPECT_TRUE(rc::check([] {
        double const radius = 0.04 + 0.2 * unit();
        double const speed = 0.3 + 5 * unit();
        SmallWorld world;
        layTiles(world, 0.15 + 0.3 * unit());
        SlotIndex const ball = world.add(
            discShape(radius), {.at = {0, radius}, .velocity = {speed, 0}, .spin = -speed / radius});
        for (int i = 0; i < 240; ++i) {
            world.step();
            RC_ASSERT(world.motions[ball].centre.y < radius + 1e-3);
        }
        RC_ASSERT(std::abs(world.motions[ball].velocity.x - speed) < 0.005 * speed);
    }));
}

TEST(NativeSeams, ACrateSlidesAsOverOnePlate) {
    SmallWorld world;
    layTiles(world, 0.2);
    SlotIndex const crate = world.add(boxShape(0.3, 0.3), {.at = {0, 0.15}, .velocity = {5, 0}});
    world.step(180);
    EXPECT_NEAR(world.motions[crate].centre.x, 25 / (2 * 0.5 * standardGravity), 0.1);
    EXPECT_NEAR(world.motions[crate].angle, 0, 1e-3);
}

TEST(NativeSeams, ABallThatBouncesBesideASeamStays) {
    SmallWorld world;
    layTiles(world, 0.2, 0.9);
    SlotIndex const ball = world.add(discShape(0.1), {.at = {0.11, 0.6}, .restitution = 0.9});
    world.step(300);
    EXPECT_NEAR(world.motions[ball].centre.x, 0.11, 1e-6);
}

} // namespace
} // namespace native_seams_test
} // namespace trembler::test
