// The same acceleration everywhere, against mass times acceleration.
#include "tests/physics/gravity/mass_world.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

TEST(LinearGravity, IsMassTimesAcceleration) {
    for (Vec2 const acceleration :
         {Vec2{0, -9.81}, Vec2{0, -3.72}, Vec2{1.5, 0}}) { // Earth, Mars, a tilted world
        MassWorld scene;
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

// Gravity is one number in one place (3.3.3): if it changes in a running world, every weight changes.
TEST(LinearGravity, FollowsTheWorldsGravity) {
    MassWorld scene;
    scene.linear({0, -9.81});
    scene.mass(10);
    EXPECT_DOUBLE_EQ(scene.forces()[0].force.y, -98.1);
    ObjectId const world = scene.world.store().find("field");
    scene.world.store().column<GravityField>().set(world, {{0, -3.72}});
    scene.world.step();
    EXPECT_DOUBLE_EQ(scene.world.find<GravityForce>()->forces[0].force.y, -37.2);
}

TEST(LinearGravity, SleepsWhileBodiesOnlyMove) {
    MassWorld scene;
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

} // namespace
} // namespace trembler::test
