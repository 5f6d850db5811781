// Impacts at the same moment, against the symmetry of what meets.
#include "tests/physics/dynamics/engines/native/small_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler::test {
namespace native_tied_impact_test {
namespace {

TEST(NativeTiedImpacts, ThrowABallOutOfANotchTheWayItCame) {
    for (double const e : {0.3, 0.8, 1.0}) {
        for (bool const leftFirst : {true, false}) {
            SmallWorld world(0);
            double const half = leftFirst ? -1.2 : 1.2;
            for (double const x : {half, -half}) {
                world.add(boxShape(2, 1), {.at = {x, -0.5}, .restitution = e, .fixed = true});
            }
            SlotIndex const ball = world.add(
                discShape(0.5), {.at = {0, 2}, .velocity = {0, -3}, .restitution = e, .friction = 0});
            for (int i = 0; i < 60; ++i) {
                world.step();
            }
            EXPECT_NEAR(world.motions[ball].velocity.y, 3 * e, 1e-6) << e;
            EXPECT_NEAR(world.motions[ball].velocity.x, 0, 1e-6) << e;
            EXPECT_NEAR(world.motions[ball].spin, 0, 1e-6) << e;
        }
    }
}

TEST(NativeTiedImpacts, SplitABreakShotEvenly) {
    // A ball meets two that touch each other, elastically and without friction: by the symmetry and the laws
    // of momentum and energy it leaves with -1/5 of its speed, they with 2√3/5 of it, 30° aside. It is slow,
    // since the direction of an impact is that of the step's beginning.
    double const r = 0.1;
    double const v = 0.02;
    SmallWorld world(0);
    double const meets = 1 - r * std::sqrt(3.0);
    SlotIndex const cue = world.add(
        discShape(r), {.at = {meets - 0.01, 0}, .velocity = {v, 0}, .restitution = 1, .friction = 0});
    SlotIndex const upper = world.add(discShape(r), {.at = {1, r}, .restitution = 1, .friction = 0});
    SlotIndex const lower = world.add(discShape(r), {.at = {1, -r}, .restitution = 1, .friction = 0});
    world.step(60);
    EXPECT_NEAR(world.motions[cue].velocity.x, -v / 5, 0.01 * v);
    EXPECT_NEAR(world.motions[cue].velocity.y, 0, 1e-9);
    double const away = 2 * std::sqrt(3.0) / 5 * v;
    for (SlotIndex const ball : {upper, lower}) {
        double const side = ball == upper ? 1 : -1;
        EXPECT_NEAR(world.motions[ball].velocity.x, away * std::cos(pi / 6), 0.01 * v);
        EXPECT_NEAR(world.motions[ball].velocity.y, side * away * std::sin(pi / 6), 0.01 * v);
    }
}

} // namespace
} // namespace native_tied_impact_test
} // namespace trembler::test
