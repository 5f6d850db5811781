// What swings for ever keeps its energy, and joints stay closed.
#include "tests/physics/dynamics/engines/native/small_world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>
#include <random>

namespace trembler::test {
namespace smooth_motion_test {
namespace {

double unit() {
    return *rc::gen::inRange(0, 1000001) / 1e6;
}

// Links of a length, hung from the origin in a line at an angle; those of one group do not collide.
std::vector<SlotIndex> hang(SmallWorld& world, int links, double size, double angle) {
    std::vector<SlotIndex> all;
    SlotIndex last = noSlot;
    Vec2 const along = rotated({1, 0}, angle);
    for (int i = 0; i < links; ++i) {
        SlotIndex const link = world.add(boxShape(size, size / 6),
                                         {.at = (i + 0.5) * size * along, .angle = angle, .group = -1});
        world.hinge(link, last, i * size * along);
        last = link;
        all.push_back(link);
    }
    return all;
}

// The energy of a pendulum of so many links, at each of the frames, as a share of what it can fall.
double worstOf(int links, double size, double angle, int frames) {
    SmallWorld world;
    std::vector<SlotIndex> const all = hang(world, links, size, angle);
    double const before = world.energy();
    double scale = 0;
    for (int i = 0; i < links; ++i) {
        scale += world.masses[all[static_cast<std::size_t>(i)]] * standardGravity * size * (i + 0.5);
    }
    double worst = 0;
    for (int i = 0; i < frames; ++i) {
        world.step();
        worst = std::max(worst, std::abs(world.energy() - before) / scale);
        Motion const& first = world.motions[all[0]];
        EXPECT_LT(length(first.centre - rotated({size / 2, 0}, first.angle)), 1e-9);
    }
    return worst;
}

TEST(SmoothMotion, KeepsTheEnergyOfPendulums) {
    // A few only, as a double and a triple pendulum take long.
    std::mt19937 random(4242);
    auto const between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 8U) * 0x1p-24;
    };
    for (int i = 0; i < 4; ++i) {
        double const size = between(0.2, 2.2);
        double const angle = between(0, 2 * std::numbers::pi);
        EXPECT_LT(worstOf(1, size, angle, 600), 0.0005) << size << " m at " << angle;
        EXPECT_LT(worstOf(2, size, angle, 600), 0.002) << size << " m at " << angle;
        EXPECT_LT(worstOf(3, size, angle, 600), 0.005) << size << " m at " << angle;
    }
}

// 2π √(l/g) for small swings: of a rod of length s about its end, l = 2 s / 3.
TEST(SmoothMotion, SwingsWithTheFrequencyOfTheFormula) {
    SmallWorld world;
    double const size = 1;
    double const start = -std::numbers::pi / 2 + 0.01;
    SlotIndex const rod = hang(world, 1, size, start)[0];
    double const inertia = world.inertias[rod] + world.masses[rod] * size * size / 4;
    double const period =
        2 * std::numbers::pi * std::sqrt(inertia / (world.masses[rod] * standardGravity * size / 2));
    int const frames = static_cast<int>(std::lround(20 * period * 60));
    world.step(frames);
    double const phase = 2 * std::numbers::pi * (frames / 60.0) / period;
    EXPECT_NEAR(world.motions[rod].angle, -std::numbers::pi / 2 + 0.01 * std::cos(phase), 1e-4);
}

TEST(SmoothMotion, CirclesAboutAPinForEver) {
    SmallWorld world(0);
    SlotIndex const ball = world.add(discShape(0.1), {.at = {1, 0}, .velocity = {0, 6}});
    world.join(JointForm::distance, ball, noSlot, {1, 0}, {0, 0}, 1);
    world.step(600);
    EXPECT_NEAR(length(world.motions[ball].velocity), 6, 1e-4);
    EXPECT_NEAR(length(world.motions[ball].centre), 1, 1e-9);
    double const angle = std::atan2(world.motions[ball].centre.y, world.motions[ball].centre.x);
    EXPECT_NEAR(std::remainder(angle - 60, 2 * std::numbers::pi), 0, 1e-3);
}

TEST(SmoothMotion, KeepsTheSwingOfSprings) {
    EXPECT_TRUE(rc::check([] {
        double const frequency = 0.3 + 9.7 * unit();
        SmallWorld world(0);
        SlotIndex const ball = world.add(discShape(0.1), {.at = {1.1, 0}});
        double const stiffness = world.masses[ball] * std::pow(2 * std::numbers::pi * frequency, 2);
        world.join(JointForm::spring, ball, noSlot, {1.1, 0}, {0, 0}, 1, stiffness);
        for (int i = 1; i <= 600; ++i) {
            world.step();
            double const stretch = world.motions[ball].centre.x - 1;
            double const speed = world.motions[ball].velocity.x;
            double const energy = stiffness * stretch * stretch + world.masses[ball] * speed * speed;
            RC_ASSERT(std::abs(energy / (stiffness * 0.01) - 1) < 0.005);
        }
    }));
}

TEST(SmoothMotion, ChainsNeitherStretchNorGainEnergyWhateverHangsOnThem) {
    for (double const ratio : {1.0, 100.0, 1000.0}) {
        SmallWorld world;
        constexpr int links = 30;
        double const size = 0.2;
        std::vector<SlotIndex> const chain = hang(world, links, size, 0);
        double const link = world.masses[chain[0]];
        SlotIndex const ball =
            world.add(discShape(0.1), {.at = {links * size + 0.1, 0}, .mass = ratio * link, .group = -1});
        world.hinge(ball, chain.back(), {links * size, 0});
        double const before = world.energy();
        for (int i = 0; i < 120; ++i) {
            world.step();
            ASSERT_LT(length(world.motions[ball].centre), links * size + 0.1 + 1e-6) << ratio;
            ASSERT_NEAR(world.energy(), before, 1e-3 * ratio * link * standardGravity * 6) << ratio;
        }
    }
}

} // namespace
} // namespace smooth_motion_test
} // namespace trembler::test
