// Archimedes' law: the draught of floating bodies in different places and liquids.
#include "tests/physics/buoyancy/pool.hpp"

#include <gtest/gtest.h>

#include <array>

namespace trembler::test {
namespace {

// The draught of a circle that floats with this ratio of densities: by bisection on the segment's area.
double draughtOfCircle(double radius, double ratio) {
    double low = 0;
    double high = 2 * radius;
    for (int i = 0; i < 100; ++i) {
        double const depth = (low + high) / 2;
        double const c = 1 - depth / radius;
        double const area = radius * radius * (std::acos(c) - c * std::sqrt(1 - c * c));
        (area < ratio * pi * radius * radius ? low : high) = depth;
    }
    return low;
}

class Floating : public ::testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] Pool::Options options() const {
        Pool::Options options;
        options.detail = GetParam();
        options.buoyancy.particles = 256;
        return options;
    }
    [[nodiscard]] bool exact() const { return GetParam() == "exact"; }
};

INSTANTIATE_TEST_SUITE_P(Levels, Floating, ::testing::Values("exact", "particles"),
                         [](auto const& info) { return info.param; });

TEST_P(Floating, BoxesSettleAtTheirDraught) {
    Pool pool(options());
    Liquid calm;
    calm.linearDrag = 3;
    pool.water(calm);
    std::array<double, 7> const ratios{0.02, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99};
    std::vector<ObjectId> boxes;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        boxes.push_back(pool.body("box " + std::to_string(i), boxPiece(0.6, 0.2),
                                  {-6 + 2.0 * static_cast<double>(i), 0.05}, 1000 * ratios[i]));
    }
    pool.seconds(30);
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        double const draught = 0.1 - pool.at(boxes[i]).y; // of the lower side below y = 0
        EXPECT_NEAR(draught, 0.2 * ratios[i], exact() ? 2e-4 : 6e-3) << ratios[i];
        EXPECT_NEAR(pool.angle(boxes[i]), 0, exact() ? 1e-4 : 2e-3) << ratios[i];
        EXPECT_NEAR(pool.force(boxes[i]).y / (pool.mass(boxes[i]) * 9.81), 1, 1e-3) << ratios[i];
        EXPECT_EQ(pool.force(boxes[i]).x, 0);
    }
}

TEST_P(Floating, CirclesAndCapsulesSettleAtTheirDraught) {
    Pool pool(options());
    Liquid calm;
    calm.linearDrag = 3;
    pool.water(calm);
    for (double const ratio : {0.1, 0.3, 0.5, 0.8}) {
        std::string const name = std::to_string(ratio);
        pool.body("ball " + name, circlePiece(0.3), {-9 + 20 * ratio, 0}, 1000 * ratio);
        pool.body("capsule " + name, capsulePiece(0.8, 0.2), {-8 + 20 * ratio, 0}, 1000 * ratio);
    }
    pool.seconds(30);
    for (double const ratio : {0.1, 0.3, 0.5, 0.8}) {
        std::string const name = std::to_string(ratio);
        ObjectId const ball = pool.world->store().find("ball " + name);
        EXPECT_NEAR(0.3 - pool.at(ball).y, draughtOfCircle(0.3, ratio), exact() ? 3e-4 : 6e-3) << ratio;
        // A capsule on its side: box and circle at the same depth.
        ObjectId const capsule = pool.world->store().find("capsule " + name);
        double const depth = 0.2 - pool.at(capsule).y;
        double const c = 1 - depth / 0.2;
        double const wet = 0.4 * depth + 0.04 * (std::acos(c) - c * std::sqrt(1 - c * c));
        EXPECT_NEAR(wet / (0.4 * 0.4 + pi * 0.04), ratio, exact() ? 1e-3 : 2e-2) << ratio;
    }
}

TEST_P(Floating, OnTheMoonOnlyForcesAndPeriodsDiffer) {
    // Draught does not depend on gravity; force and period do.
    std::array<double, 2> draughts{};
    for (std::size_t i = 0; i < 2; ++i) {
        Pool::Options moon = options();
        moon.gravity = {0, i == 0 ? -9.81 : -1.62};
        Pool pool(moon);
        pool.water();
        ObjectId const box = pool.body("box", boxPiece(0.4, 0.2), {0, 0.1}, 400);
        pool.seconds(60);
        draughts[i] = 0.1 - pool.at(box).y;
        EXPECT_NEAR(pool.force(box).y, -pool.mass(box) * moon.gravity.y, 1e-3 * pool.mass(box) * 9.81);
    }
    EXPECT_NEAR(draughts[0], draughts[1], exact() ? 1e-3 : 6e-3);
    EXPECT_NEAR(draughts[1], 0.08, exact() ? 1e-3 : 6e-3);
}

TEST_P(Floating, WithoutGravityNothingIsLifted) {
    Pool::Options space = options();
    space.gravity = {};
    Pool pool(space);
    pool.water();
    ObjectId const box = pool.body("box", boxPiece(0.4, 0.2), {0, 0}, 10);
    pool.seconds(2);
    EXPECT_EQ(pool.at(box).y, 0);
    EXPECT_EQ(length(pool.force(box)), 0);
}

TEST_P(Floating, GravityMayPointAnywhere) {
    // A pool on its side, its surface to the right, in a world where down is to the left.
    Pool::Options sideways = options();
    sideways.gravity = {-9.81, 0};
    Pool pool(sideways);
    pool.liquid("water", boxPiece(100, 50), {-25, 0}, 1000, {}, -pi / 2);
    ObjectId const box = pool.body("box", boxPiece(0.2, 0.6), {0.05, 0}, 500);
    pool.seconds(20);
    EXPECT_NEAR(pool.at(box).x, 0, exact() ? 5e-4 : 6e-3);
    EXPECT_NEAR(pool.at(box).y, 0, 1e-2);
    EXPECT_GT(pool.force(box).x, 0);
}

TEST_P(Floating, BodiesFloatInAnyDenserLiquid) {
    // Iron floats on mercury, 7870 / 13546 of it below the surface; wood does not float on petrol's vapour.
    Pool pool(options());
    pool.liquid("mercury", boxPiece(4, 2), {0, -1}, 13546);
    pool.liquid("vapour", boxPiece(4, 2), {6, -1}, 3.4);
    ObjectId const iron = pool.body("iron", boxPiece(0.4, 0.2), {0, 0}, 7870);
    ObjectId const wood = pool.body("wood", boxPiece(0.4, 0.2), {6, 0}, 600);
    pool.seconds(20);
    EXPECT_NEAR(0.1 - pool.at(iron).y, 0.2 * 7870 / 13546, exact() ? 5e-4 : 6e-3);
    EXPECT_LT(pool.at(wood).y, -50);
}

TEST_P(Floating, ABodyFloatsBetweenTwoLiquids) {
    // Oil on water: a box of a density in between carries both; the displaced mass of both is its mass.
    Pool pool(options());
    pool.liquid("water", boxPiece(20, 5), {0, -2.5}, 1000);
    pool.liquid("oil", boxPiece(20, 1), {0, 0.5}, 850);
    ObjectId const box = pool.body("box", boxPiece(0.6, 0.2), {0, 0.2}, 900);
    pool.seconds(40);
    // 850 (h - d) + 1000 d = 900 h, with d the depth in water.
    EXPECT_NEAR(0.1 - pool.at(box).y, 0.2 / 3, exact() ? 1e-3 : 1e-2);
    EXPECT_EQ(pool.world->find<Immersions>()->entries.size(), 2U);
}

TEST_P(Floating, BodiesSlideDownATiltedSurface) {
    // Across the surface the displaced mass is the ball's, as on a level one. Along it only drag holds the
    // ball: g sin t = c v, as the displaced mass is the ball's; v is the velocity of the immersed part (the
    // ball also turns, because only its lower half is held back).
    double const tilt = 20 * pi / 180;
    Liquid slow;
    slow.linearDrag = 2;
    slow.quadraticDrag = 0;
    Pool pool(options());
    pool.liquid("slope", boxPiece(80, 20), rotated({0, -10}, tilt), 1000, slow, tilt);
    ObjectId const ball = pool.body("ball", circlePiece(0.25), rotated({30, 0}, tilt), 500);
    pool.seconds(10);
    // Half of the disc is below the surface: its centre is on it.
    Vec2 const seen = rotated(pool.at(ball), -tilt);
    Vec2 const arm = pool.centre(ball) - pool.at(ball);
    Vec2 const motion = rotated(pool.velocity(ball) + pool.spin(ball) * perpendicular(arm), -tilt);
    EXPECT_NEAR(seen.y, 0, exact() ? 1e-3 : 1e-2);
    EXPECT_NEAR(motion.x, -9.81 * std::sin(tilt) / 2, exact() ? 5e-3 : 5e-2);
    Vec2 const force = rotated(pool.force(ball), -tilt);
    EXPECT_NEAR(force.x, 0, 1e-9 * force.y);
    EXPECT_NEAR(force.y / (pool.mass(ball) * 9.81 * std::cos(tilt)), 1, 1e-2);
    // The centroid of a half disc is 4r/3π from the cut, and F_B pulls through the ball's centre.
    Vec2 const centre = rotated(arm, -tilt);
    EXPECT_NEAR(centre.y, -4 * 0.25 / (3 * pi), exact() ? 1e-3 : 1e-2);
    EXPECT_NEAR(centre.x, 0, exact() ? 1e-9 : 1e-2);
}

} // namespace
} // namespace trembler::test
