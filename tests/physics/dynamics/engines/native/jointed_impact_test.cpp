// Impacts of bodies on joints against the law of impacts for a lever, at random measures.
#include "tests/physics/dynamics/engines/native/small_world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler::test {
namespace jointed_impact_test {
namespace {

double between(double low, double high) {
    return low + (high - low) * (*rc::gen::inRange(0, 1000001) / 1e6);
}

// A ball strikes a lever that a pin holds in its middle: with the moment of inertia I about the pin, the arm
// r and the ball's speed v, the lever turns with (1 + e) m v r / (I + m r²).
TEST(JointedImpacts, TurnALeverByTheFormula) {
    EXPECT_TRUE(rc::check([] {
        double const e = between(0.05, 1);
        double const mass = std::pow(10, between(-1, 2));
        double const speed = between(0.5, 20);
        double const arm = between(0.3, 1) * (*rc::gen::arbitrary<bool>() ? 1 : -1);
        SmallWorld world(0);
        SlotIndex const lever = world.add(boxShape(2.4, 0.08), {.at = {0, 0}, .mass = 10});
        SlotIndex const ball = world.add(
            discShape(0.1), {.at = {arm, 0.5}, .velocity = {0, -speed}, .mass = mass, .restitution = e});
        world.hinge(lever, noSlot, {0, 0});
        for (int i = 0; i < 120 && world.changes.empty(); ++i) {
            world.step();
        }
        double const whole = world.inertias[lever] + mass * arm * arm;
        double const turns = -(1 + e) * mass * speed * arm / whole;
        RC_ASSERT(std::abs(world.motions[lever].spin - turns) < 5e-3 * std::abs(turns));
        RC_ASSERT(std::abs(world.motions[ball].velocity.y - (turns * arm + e * speed)) < 5e-3 * speed);
        RC_ASSERT(length(world.motions[lever].velocity) < 1e-9 * speed);
    }));
}

// However many bodies a joint holds, an elastic impact keeps the energy.
TEST(JointedImpacts, KeepTheEnergyOfAChain) {
    SmallWorld world(0);
    SlotIndex last = noSlot;
    for (int i = 0; i < 8; ++i) {
        SlotIndex const link = world.add(boxShape(0.2, 0.04), {.at = {0.2 * (i + 0.5), 0}, .mass = 1});
        world.hinge(link, last, {0.2 * i, 0});
        last = link;
    }
    world.add(discShape(0.1), {.at = {1.1, 0.5}, .velocity = {0, -3}, .mass = 2, .restitution = 1});
    double const before = world.energy();
    for (int i = 0; i < 12; ++i) {
        world.step();
        EXPECT_NEAR(world.energy(), before, 0.01 * before) << i;
    }
}

} // namespace
} // namespace jointed_impact_test
} // namespace trembler::test
