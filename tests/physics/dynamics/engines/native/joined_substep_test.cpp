// Joints with contacts: what bears does not bend, and what strikes does not tear.
#include "tests/physics/dynamics/engines/native/small_world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler::test {
namespace joined_substep_test {
namespace {

double unit() {
    return *rc::gen::inRange(0, 1000001) / 1e6;
}

TEST(JoinedSubstep, WeldedBoxesBearALoadWithoutBending) {
    SmallWorld world;
    SlotIndex last = world.add(boxShape(2, 0.2), {.at = {-1, -0.1}, .fixed = true});
    for (int i = 0; i < 10; ++i) {
        SlotIndex const box = world.add(boxShape(0.2, 0.2), {.at = {0.1 + 0.2 * i, -0.1}, .mass = 0.5});
        world.join(JointForm::weld, box, last, {0.2 * i, -0.1}, {0.2 * i, -0.1});
        last = box;
    }
    SlotIndex const load = world.add(boxShape(0.2, 0.2), {.at = {1.9, 0.1}, .mass = 1});
    world.step(600);
    EXPECT_NEAR(world.motions[last].centre.y, -0.1, 1e-6);
    EXPECT_NEAR(world.motions[load].centre.y, 0.1, 1e-3);
}

// A chain that falls onto itself and onto the floor.
TEST(JoinedSubstep, AChainThatStrikesThingsKeepsItsLengthAndGainsNoEnergy) {
    for (double const ratio : {1.0, 100.0}) {
        SmallWorld world;
        world.add(boxShape(20, 0.2), {.at = {0, -3}, .fixed = true});
        SlotIndex last = noSlot;
        constexpr int links = 20;
        double mass = 0;
        std::vector<SlotIndex> chain;
        for (int i = 0; i < links; ++i) {
            SlotIndex const link = world.add(boxShape(0.2, 0.04), {.at = {0.2 * (i + 0.5), 0}});
            mass = world.masses[link];
            world.hinge(link, last, {0.2 * i, 0});
            last = link;
            chain.push_back(link);
        }
        SlotIndex const ball =
            world.add(discShape(0.1), {.at = {0.2 * links + 0.1, 0}, .mass = ratio * mass});
        world.hinge(ball, last, {0.2 * links, 0});
        double const before = world.energy();
        for (int i = 0; i < 300; ++i) {
            world.step();
            for (std::size_t n = 1; n < chain.size(); ++n) {
                Motion const& one = world.motions[chain[n - 1]];
                Motion const& next = world.motions[chain[n]];
                Vec2 const gap =
                    one.centre + rotated({0.1, 0}, one.angle) - next.centre - rotated({-0.1, 0}, next.angle);
                ASSERT_LT(length(gap), 1e-4) << ratio << ", frame " << i << ", link " << n;
            }
            ASSERT_LT(world.energy(), before + 0.01 * ratio * mass * standardGravity * 4)
                << ratio << ", frame " << i;
        }
    }
}

TEST(JoinedSubstep, ARopePullsAndNeverPushes) {
    SmallWorld world(0);
    SlotIndex const ball = world.add(discShape(0.1), {.at = {0.5, 0}, .velocity = {-1, 0}});
    world.join(JointForm::rope, ball, noSlot, {0.5, 0}, {0, 0}, 1);
    world.step(60);
    EXPECT_NEAR(world.motions[ball].centre.x, -0.5, 1e-6); // slack
    world.step(60);
    EXPECT_GT(world.motions[ball].centre.x, -1 - 1e-6); // taut
}

// Two bodies that are welded to a third one and lie flush beside each other: their contact says what the
// welds say.
TEST(JoinedSubstep, FlushBodiesThatWeldsHoldFallAsOne) {
    EXPECT_TRUE(rc::check([] {
        double const size = 0.05 * std::pow(20, unit());
        double const spin = 4 * unit() - 2;
        SmallWorld world;
        SlotIndex const bar = world.add(boxShape(2 * size, size), {.at = {0, 0}, .spin = spin});
        double const aside = size / 2;
        auto const beside = [&](double x) {
            return SmallBody{.at = {x, size}, .velocity = {-spin * size, spin * x}, .spin = spin};
        };
        SlotIndex const left = world.add(boxShape(size, size), beside(-aside));
        SlotIndex const right = world.add(boxShape(size, size), beside(aside));
        world.join(JointForm::weld, bar, left, {-aside, size / 2}, {-aside, size / 2});
        world.join(JointForm::weld, bar, right, {aside, size / 2}, {aside, size / 2});
        world.step(60);
        Vec2 centre{};
        double mass = 0;
        for (SlotIndex const slot : {bar, left, right}) {
            centre += world.masses[slot] * world.motions[slot].centre;
            mass += world.masses[slot];
            RC_ASSERT(std::abs(world.motions[slot].angle - spin) < 1e-6);
        }
        centre = 1 / mass * centre;
        // The bar and both boxes have the same mass, so the centre begins at half a box.
        double const x = -spin * size / 2;
        RC_ASSERT(std::abs(centre.x - x) < 1e-6);
        RC_ASSERT(std::abs(centre.y - (size / 2 - standardGravity / 2)) < 1e-6);
    }));
}

// Two welds between the same bodies say the same: how they share a load is not determined, and must not
// become motion.
TEST(JoinedSubstep, WeldsThatSayTheSameGainNoEnergy) {
    for (double const tilt : {0.02, 0.35}) {
        SmallWorld world;
        world.floor();
        Vec2 const at{0, 2};
        Vec2 const along = rotated(Vec2{1, 0}, tilt);
        Vec2 const up = rotated(Vec2{0, 1}, tilt);
        SlotIndex const lower = world.add(boxShape(1, 0.1), {.at = at, .angle = tilt, .restitution = 0.5});
        SlotIndex const upper =
            world.add(boxShape(1, 0.1), {.at = at + 0.3 * up, .angle = tilt, .restitution = 0.5});
        for (double const side : {-0.4, 0.4}) {
            Vec2 const place = at + side * along + 0.15 * up;
            world.join(JointForm::weld, lower, upper, place, place);
        }
        double const before = world.energy();
        for (int i = 0; i < 300; ++i) {
            world.step();
            ASSERT_LT(world.energy(), before + 1e-6) << tilt << ", frame " << i;
        }
        EXPECT_NEAR(length(world.motions[upper].centre - world.motions[lower].centre), 0.3, 1e-6);
    }
}

} // namespace
} // namespace joined_substep_test
} // namespace trembler::test
