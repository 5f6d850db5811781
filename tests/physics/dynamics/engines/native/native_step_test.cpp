// Free motion, far places, and that a heavy stack costs what it costs alone.
#include "tests/physics/dynamics/engines/native/small_world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler::test {
namespace native_step_test {
namespace {

double unit() {
    return *rc::gen::inRange(0, 1000001) / 1e6;
}

TEST(NativeStep, ThrownBodiesFollowTheParabola) {
    EXPECT_TRUE(rc::check([] {
        Vec2 const velocity{40 * unit() - 20, 40 * unit() - 20};
        SmallWorld world;
        world.engine->chooseSubsteps(false);
        world.settings.substeps = *rc::gen::inRange(1, 9);
        SlotIndex const ball = world.add(discShape(0.1), {.at = {0, 0}, .velocity = velocity});
        world.step(120);
        RC_ASSERT(std::abs(world.motions[ball].centre.x - 2 * velocity.x) < 1e-9);
        RC_ASSERT(std::abs(world.motions[ball].centre.y - (2 * velocity.y - 2 * standardGravity)) < 1e-9);
    }));
}

// A force that is computed once in each frame, from the place then: the method of Verlet swings for ever with
// the angle θ in each frame, cos θ = 1 - (ω h)²/2.
TEST(NativeStep, AForceByThePlaceIsIntegratedToTheSecondOrder) {
    for (double const omega : {1.0, 6.0, 30.0}) {
        SmallWorld world(0);
        SlotIndex const ball = world.add(discShape(0.1), {.at = {1, 0}});
        double const theta = std::acos(1 - omega * omega / 7200);
        for (int n = 0; n < 600; ++n) {
            ASSERT_NEAR(world.motions[ball].centre.x, std::cos(n * theta), 1e-9) << omega << " " << n;
            world.loads[ball].varies = true;
            world.loads[ball].force.x = -omega * omega * world.masses[ball] * world.motions[ball].centre.x;
            world.step();
        }
    }
}

TEST(NativeStep, FarPlacesAreAsGoodAsTheOrigin) {
    for (double const far : {0.0, 2e4, 1e6}) {
        SmallWorld world;
        world.add(boxShape(20, 0.2), {.at = {far, -0.1}, .fixed = true});
        SlotIndex const ball =
            world.add(discShape(0.1), {.at = {far, 0.1}, .velocity = {0.3, 0}, .spin = -3});
        world.step(600);
        EXPECT_NEAR(world.motions[ball].centre.x - far, 3, 1e-3) << far;
    }
}

TEST(NativeStep, TheMotionIsTheSameInAnyOtherPlaceOfTheList) {
    // Two worlds that differ by a body far away, made first in one and last in the other.
    auto const run = [](bool first) {
        SmallWorld world;
        if (first) {
            world.add(discShape(0.1), {.at = {50, 50}});
        }
        world.floor();
        SlotIndex top = 0;
        for (int i = 0; i < 5; ++i) {
            top = world.add(boxShape(0.2, 0.2), {.at = {0.03 * i, 0.21 * (i + 0.5)}});
        }
        if (!first) {
            world.add(discShape(0.1), {.at = {50, 50}});
        }
        world.step(200);
        return world.motions[top];
    };
    Motion const one = run(true);
    Motion const other = run(false);
    EXPECT_EQ(one.centre.x, other.centre.x);
    EXPECT_EQ(one.centre.y, other.centre.y);
    EXPECT_EQ(one.angle, other.angle);
}

} // namespace
} // namespace native_step_test
} // namespace trembler::test
