#include "physics/dynamics/core/point_pull.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace trembler::test {
namespace {

TEST(PointPull, ForceGivesThePointItsAccelerationByNewtonAndEuler) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-3, 3);
    std::uniform_real_distribution<double> positive(0.01, 4);
    for (int i = 0; i < 1000; ++i) {
        Vec2 const wanted{number(random), number(random)};
        Vec2 const arm{number(random), number(random)};
        double const mass = positive(random);
        double const inertiaPerMass = positive(random);
        Vec2 const force = forceToAccelerate(wanted, arm, mass, inertiaPerMass);
        // The centre follows the force, and the body turns by its moment: a = F/m + α × r, at rest.
        double const turning = (arm.x * force.y - arm.y * force.x) / (mass * inertiaPerMass);
        double const x = force.x / mass - turning * arm.y;
        double const y = force.y / mass + turning * arm.x;
        EXPECT_NEAR(x, wanted.x, 1e-9);
        EXPECT_NEAR(y, wanted.y, 1e-9);
    }
}

TEST(PointPull, AtTheCentreOrAlongTheArmTheWholeMassResists) {
    Vec2 const atCentre = forceToAccelerate({1, -2}, {0, 0}, 3, 0.5);
    EXPECT_EQ(atCentre, (Vec2{3, -6}));
    Vec2 const along = forceToAccelerate({2, 0}, {5, 0}, 3, 0.5);
    EXPECT_EQ(along, (Vec2{6, 0}));
}

// x(t) = (x0 + (v0 + ω x0) t) exp(-ω t) is the motion of a critically damped oscillator.
TEST(PointPull, SpringIsCriticallyDamped) {
    double const frequency = 12;
    double const start = 0.7;
    double const speed = -1.5;
    double x = start;
    double v = speed;
    double const step = 1e-6;
    for (int i = 1; i <= 500000; ++i) {
        v += step * criticallyDamped(frequency, {-x, 0}, {v, 0}).x;
        x += step * v;
        if (i % 100000 == 0) {
            double const t = i * step;
            double const exact = (start + (speed + frequency * start) * t) * std::exp(-frequency * t);
            EXPECT_NEAR(x, exact, 1e-4) << t;
        }
    }
}

} // namespace
} // namespace trembler::test
