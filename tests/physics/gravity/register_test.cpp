// The detail levels of gravity together.
#include "tests/physics/gravity/mass_world.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

TEST(GravityLevels, OfferTheSamePropertyAndALawSelectsRealGravity) {
    MassWorld scene;
    scene.linear({0, -10});
    scene.real(1, 0.001);
    scene.mass(1, {0, 0});
    scene.mass(1, {2, 0});
    EXPECT_NEAR(scene.forces()[0].force.x, 0.25, 1e-6);
    scene.world.setDetail("gravity", "linear");
    scene.world.step();
    EXPECT_EQ(scene.world.find<GravityForce>()->forces[0].force, (Vec2{0, -10}));
}

} // namespace
} // namespace trembler::test
