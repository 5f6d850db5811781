// The pull of every mass at every other, against Newton's law.
#include "tests/physics/gravity/mass_world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler::test {
namespace {

TEST(RealGravity, IsNewtonsLawSoftenedAfterPlummer) {
    MassWorld scene;
    scene.real(2, 0.3);
    scene.mass(5, {0, 0});
    scene.mass(7, {3, 4});
    scene.mass(11, {-2, 1});
    auto const& forces = scene.forces();
    ASSERT_EQ(forces.size(), 3U);
    // The force on the first mass: from the second, 5 m away, and from the third, sqrt(5) m away.
    double const second = 2 * 5 * 7 / std::pow(25 + 0.09, 1.5);
    double const third = 2 * 5 * 11 / std::pow(5 + 0.09, 1.5);
    EXPECT_NEAR(forces[0].force.x, 3 * second - 2 * third, 1e-13);
    EXPECT_NEAR(forces[0].force.y, 4 * second + 1 * third, 1e-13);
}

// Two spheres of 1000 kg, 1 m apart: 6.6743e-5 N, Newton's constant as it is measured (CODATA 2018).
TEST(RealGravity, HasTheRealConstantUnlessTheWorldStatesAnother) {
    MassWorld scene;
    scene.world.store().column<GravityLaw>().addDefault(scene.world.store().create("law"));
    scene.mass(1000, {0, 0});
    scene.mass(1000, {1, 0});
    double const plain = 6.6743e-11 * 1e6;
    EXPECT_NEAR(scene.forces()[0].force.x, plain, 2e-4 * plain)
        << "the softening of 1 cm reduces the force by 0.015 %";
}

TEST(RealGravity, ConservesMomentumAndExertsNoTorqueOnTheWhole) {
    EXPECT_TRUE(rc::check([] {
        auto const number = [](double low, double high) {
            return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
        };
        MassWorld scene;
        scene.real(1, number(0.001, 1));
        auto const count = *rc::gen::inRange(2, 30);
        for (int i = 0; i < count; ++i) {
            scene.mass(number(0.001, 1000), {number(-50, 50), number(-50, 50)});
        }
        Vec2 total;
        double torque = 0;
        double scale = 0;
        for (GravityForce::Entry const& entry : scene.forces()) {
            total += entry.force;
            torque += cross(scene.world.find<Position>(entry.object)->value, entry.force);
            scale += length(entry.force);
        }
        RC_ASSERT(length(total) <= 1e-13 * scale);
        RC_ASSERT(std::abs(torque) <= 1e-11 * scale);
    }));
}

TEST(RealGravity, IsFiniteAtZeroDistance) {
    MassWorld scene;
    scene.real(1, 1e-6);
    scene.mass(1e9, {1, 1});
    scene.mass(1e9, {1, 1});
    for (GravityForce::Entry const& entry : scene.forces()) {
        EXPECT_EQ(entry.force, (Vec2{0, 0}));
    }
}

// Near the surface of a world the two models are the same: g = G M / R².
TEST(RealGravity, NearAHugeMassIsLinearGravity) {
    MassWorld scene;
    double const radius = 1000;
    double const mass = 1e6;
    double const constant = 9.81 * radius * radius / mass;
    scene.real(constant, 1e-6);
    scene.mass(mass, {0, -radius});
    ObjectId const ball = scene.mass(2, {0.5, 0});
    auto const& forces = scene.forces();
    ASSERT_EQ(forces[1].object, ball);
    EXPECT_NEAR(forces[1].force.y, -2 * 9.81, 1e-4);
    EXPECT_NEAR(forces[1].force.x, -2 * 9.81 * 0.5 / radius, 1e-6);
}

TEST(RealGravityParallel, IsTheSameBitsForAnyNumberOfThreads) {
    std::vector<Vec2> first;
    for (int const threads : {1, 2, 3, 8}) {
        MassWorld scene(threads);
        scene.real(1, 0.01);
        scene.world.setDetail("gravity", "real"); // else so many masses would get the tree
        for (int i = 0; i < 3000; ++i) {
            scene.mass(1 + i % 7, {0.37 * (i % 60), 0.41 * (i / 60)});
        }
        std::vector<Vec2> forces;
        for (GravityForce::Entry const& entry : scene.forces()) {
            forces.push_back(entry.force);
        }
        if (first.empty()) {
            first = forces;
        }
        EXPECT_EQ(forces, first) << threads;
    }
}

} // namespace
} // namespace trembler::test
