// Both models of gravity compared with formulas, and with one another where they must agree.
#include "physics/dynamics/properties/body.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/gravity/register.hpp"
#include "runtime/placement.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler {
namespace gravity_test {
namespace {

Registry const& rules() {
    static Registry const registry = [] {
        Registry made;
        registerRuntime(made);
        registerGravity(made);
        return made;
    }();
    return registry;
}

struct Scene {
    explicit Scene(int threads = 1) : world(rules(), {.threads = threads, .detail = {}, .periods = {}}) {}
    ObjectId mass(double kilograms, Vec2 at = {}) {
        ObjectId const id = world.store().create("mass " + std::to_string(world.store().objects().size()));
        world.store().column<Position>().set(id, {at});
        world.store().column<Mass>().set(id, {kilograms});
        return id;
    }
    void linear(Vec2 acceleration) {
        world.store().column<GravityField>().set(world.store().create("field"), {acceleration});
    }
    void real(double constant, double softening) {
        world.store().column<GravityLaw>().set(world.store().create("law"), {constant, softening});
    }
    std::vector<GravityForce::Entry> const& forces() {
        world.start();
        world.step();
        return world.find<GravityForce>()->forces;
    }
    World world;
};

TEST(LinearGravity, IsMassTimesAcceleration) {
    for (Vec2 const acceleration :
         {Vec2{0, -9.81}, Vec2{0, -3.72}, Vec2{1.5, 0}}) { // Earth, Mars, a tilted world
        Scene scene;
        scene.linear(acceleration);
        scene.mass(2);
        scene.mass(0.125, {100, 100});
        auto const& forces = scene.forces();
        ASSERT_EQ(forces.size(), 2U);
        EXPECT_EQ(forces[0].force, 2 * acceleration);
        EXPECT_EQ(forces[1].force, 0.125 * acceleration);
        EXPECT_LT(forces[0].object, forces[1].object);
    }
}

// Mars is one number in one place (3.3.3): changed in a running world, every weight changes with it.
TEST(LinearGravity, FollowsTheOneNumberInTheOnePlace) {
    Scene scene;
    scene.linear({0, -9.81});
    scene.mass(10);
    EXPECT_DOUBLE_EQ(scene.forces()[0].force.y, -98.1);
    ObjectId const world = scene.world.store().find("field");
    scene.world.store().column<GravityField>().set(world, {{0, -3.72}});
    scene.world.step();
    EXPECT_DOUBLE_EQ(scene.world.find<GravityForce>()->forces[0].force.y, -37.2);
}

TEST(LinearGravity, SleepsWhileThingsOnlyMove) {
    Scene scene;
    scene.linear({0, -9.81});
    ObjectId const ball = scene.mass(1);
    static_cast<void>(scene.forces());
    for (int i = 0; i < 5; ++i) {
        scene.world.store().column<Position>().set(ball, {{1.0 * i, 0}});
        scene.world.step();
    }
    for (ComponentStatus const& status : scene.world.status()) {
        if (status.info->text.name == "Linear Gravity") {
            EXPECT_EQ(status.updates, 1U);
        }
    }
}

TEST(RealGravity, IsNewtonsLawSoftenedAfterPlummer) {
    Scene scene;
    scene.real(2, 0.3);
    scene.mass(5, {0, 0});
    scene.mass(7, {3, 4});
    scene.mass(11, {-2, 1});
    auto const& forces = scene.forces();
    ASSERT_EQ(forces.size(), 3U);
    // On the first: from the second, 5 m away, and from the third, sqrt(5) m away.
    double const second = 2 * 5 * 7 / std::pow(25 + 0.09, 1.5);
    double const third = 2 * 5 * 11 / std::pow(5 + 0.09, 1.5);
    EXPECT_NEAR(forces[0].force.x, 3 * second - 2 * third, 1e-13);
    EXPECT_NEAR(forces[0].force.y, 4 * second + 1 * third, 1e-13);
}

// Two spheres of 1000 kg, 1 m apart: 6.6743e-5 N, Newton's constant as it is measured (CODATA 2018).
TEST(RealGravity, HasTheRealConstantUnlessTheWorldSaysOtherwise) {
    Scene scene;
    scene.world.store().column<GravityLaw>().addDefault(scene.world.store().create("law"));
    scene.mass(1000, {0, 0});
    scene.mass(1000, {1, 0});
    double const plain = 6.6743e-11 * 1e6;
    EXPECT_NEAR(scene.forces()[0].force.x, plain, 2e-4 * plain) << "the softening of 1 cm takes 0.015 %";
}

TEST(RealGravity, ConservesMomentumAndExertsNoTorqueOnTheWhole) {
    EXPECT_TRUE(rc::check([] {
        auto const number = [](double low, double high) {
            return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
        };
        Scene scene;
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
    Scene scene;
    scene.real(1, 1e-6);
    scene.mass(1e9, {1, 1});
    scene.mass(1e9, {1, 1});
    for (GravityForce::Entry const& entry : scene.forces()) {
        EXPECT_EQ(entry.force, (Vec2{0, 0}));
    }
}

// Near the surface of a world the two models are the same: g = G M / R².
TEST(RealGravity, NearAHugeMassIsLinearGravity) {
    Scene scene;
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

TEST(GravityLevels, OfferTheSamePropertyAndAWorldWithALawMeansIt) {
    Scene scene;
    scene.linear({0, -10});
    scene.real(1, 0.001);
    scene.mass(1, {0, 0});
    scene.mass(1, {2, 0});
    EXPECT_NEAR(scene.forces()[0].force.x, 0.25, 1e-6);
    scene.world.setDetail("gravity", "linear");
    scene.world.step();
    EXPECT_EQ(scene.world.find<GravityForce>()->forces[0].force, (Vec2{0, -10}));
}

TEST(RealGravityParallel, IsTheSameBitsForAnyNumberOfThreads) {
    std::vector<Vec2> first;
    for (int const threads : {1, 2, 3, 8}) {
        Scene scene(threads);
        scene.real(1, 0.01);
        scene.world.setDetail("gravity", "real"); // or so many masses would get a tree
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
} // namespace gravity_test
} // namespace trembler
