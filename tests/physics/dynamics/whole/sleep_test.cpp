// Bodies at rest cost nothing, and wake when they should.
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

class Sleep : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Sleep);

struct Rest {
    explicit Rest(double friction = 0, double gravity = 9.81) {
        scene.gravity = gravity;
        floor = scene.fixed("floor", boxPiece(20, 1), {0, -0.5});
        box = scene.body("box", boxPiece(0.5, 0.5), {0, 0.26});
        other = scene.body("other", boxPiece(0.5, 0.5), {3, 0.26});
        for (ObjectId const id : {floor, box, other}) {
            scene.give(id, Friction{friction});
        }
        scene.run(gravity < 1 ? 600 : 200);
        EXPECT_EQ(scene.dynamics(), Activity::asleep);
    }
    Scene scene;
    ObjectId floor;
    ObjectId box;
    ObjectId other;
};

TEST_P(Sleep, APileComesToRest) {
    Scene scene;
    scene.fixed("floor", boxPiece(20, 1), {0, -0.5});
    for (int i = 0; i < 10; ++i) {
        for (int j = 0; j <= i; ++j) {
            scene.body(std::to_string(i) + " " + std::to_string(j), boxPiece(0.3, 0.3),
                       {0.32 * j - 0.16 * i, 0.16 + 0.31 * (9 - i)});
        }
    }
    scene.run(600);
    EXPECT_EQ(scene.dynamics(), Activity::asleep);
}

// As a magnet does that is pulled at one of its poles: the torque gives its far end a speed in each substep
// that looks like an impact, and must not make it bounce for ever.
TEST_P(Sleep, ABarThatIsPressedFarFromItsMiddleStopsBouncing) {
    for (double const at : {0.05, 0.12, 0.17}) {
        Scene scene;
        ObjectId const floor = scene.fixed("floor", boxPiece(20, 1), {0, -0.5});
        ObjectId const bar = scene.body("bar", boxPiece(0.4, 0.14), {0, 0.15});
        for (ObjectId const id : {floor, bar}) {
            scene.give(id, Friction{0.03});
            scene.give(id, Restitution{0.3});
        }
        scene.run(1);
        double const press = 30 * 9.81 * scene.mass(bar);
        scene.of<Pull>(bar).force = {0, -press};
        scene.of<Pull>(bar).torque = -at * press;
        scene.run(240);
        EXPECT_EQ(scene.dynamics(), Activity::asleep) << at;
        EXPECT_NEAR(scene.at(bar).y, 0.07, 0.01) << at;
    }
}

TEST_P(Sleep, RepeatedEqualForcesWakeNoBody) {
    Rest rest;
    for (int frame = 0; frame < 20; ++frame) {
        rest.scene.of<Pull>(rest.box).torque = 1e-9 * frame; // the interaction is applied again
        rest.scene.run(1);
    }
    Vec2 const at = rest.scene.at(rest.box);
    rest.scene.run(2);
    EXPECT_EQ(rest.scene.at(rest.box), at);
    EXPECT_EQ(rest.scene.dynamics(), Activity::asleep);
}

TEST_P(Sleep, AChangedForceWakesItsBody) {
    Rest rest;
    Vec2 const other = rest.scene.at(rest.other);
    rest.scene.of<Pull>(rest.box).force = {1, 0};
    rest.scene.run(61);
    EXPECT_NEAR(rest.scene.velocity(rest.box).x, 1 / rest.scene.mass(rest.box),
                2e-3 / rest.scene.mass(rest.box));
    EXPECT_EQ(rest.scene.at(rest.other), other);
    EXPECT_EQ(rest.scene.velocity(rest.other), (Vec2{}));
}

// A five-hundredth of the weight, for any gravity.
TEST_P(Sleep, OnTheMoonAForceWakesByItsShareOfTheWeightThere) {
    for (double const g : {9.81, 1.62, 0.05}) {
        Rest rest(0.5, g);
        double const weight = rest.scene.mass(rest.box) * g;
        rest.scene.of<Pull>(rest.box).force = {0.001 * weight, 0};
        rest.scene.run(3);
        EXPECT_EQ(rest.scene.dynamics(), Activity::asleep) << g;
        rest.scene.of<Pull>(rest.box).force = {0.004 * weight, 0};
        rest.scene.run(3);
        EXPECT_EQ(rest.scene.dynamics(), Activity::active) << g;
    }
}

TEST_P(Sleep, ATorqueWakes) {
    Rest rest;
    rest.scene.of<Pull>(rest.box).torque = rest.scene.mass(rest.box) * 9.81 * 0.3; // tips it over
    rest.scene.run(60);
    EXPECT_GT(rest.scene.angle(rest.box), 0.3);
}

TEST_P(Sleep, AnImpulseWakes) {
    Rest rest;
    rest.scene.give(rest.box, Kick{{0.01, 0}, rest.scene.at(rest.box), 1});
    rest.scene.run(1); // the first kick activates its interaction
    rest.scene.world->step();
    rest.scene.run(2);
    EXPECT_GT(rest.scene.velocity(rest.box).x, 0);
}

TEST_P(Sleep, FallingOntoASleepingBodyWakesItAndItsPile) {
    Rest rest(0.5);
    ObjectId const upper = rest.scene.body("upper", boxPiece(0.5, 0.5), {0.2, 3});
    rest.scene.give(upper, Velocity{{0, -3}});
    rest.scene.world->store().complete(upper);
    rest.scene.run(40);
    EXPECT_TRUE(rest.scene.touching(rest.box, upper));
    rest.scene.run(300);
    EXPECT_EQ(rest.scene.dynamics(), Activity::asleep);
}

// Box2D drops the load of a body that falls asleep. Woken by a contact, it must have its weight at once: on a
// frictionless slope, under a load that balances it, a missing load would cause a jump.
TEST_P(Sleep, AWokenBodyHasItsLoadAtOnce) {
    Rest rest(0.5);
    ObjectId const visitor = rest.scene.ball({-1, 0.11});
    rest.scene.world->store().complete(visitor);
    rest.scene.give(visitor, Velocity{{1.5, 0}});
    double highest = rest.scene.at(rest.box).y;
    double const start = highest;
    for (int frame = 0; frame < 90; ++frame) {
        rest.scene.run(1);
        highest = std::max(highest, rest.scene.at(rest.box).y);
    }
    EXPECT_LT(highest - start, 1e-4);
}

TEST_P(Sleep, AFreelyDriftingBodyIsNotAtRest) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const slow = scene.ball({0, 0});
    scene.give(slow, Velocity{{1e-3, 0}}); // a tenth of Box2D's tolerance
    scene.run(600);
    EXPECT_NEAR(scene.at(slow).x, 1e-2, 1e-4);
}

TEST_P(Sleep, AWeakForceMovesAFreeBody) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const planet = scene.ball({0, 0});
    Pull pull;
    pull.acceleration = {2e-3, 0};
    scene.give(planet, pull);
    scene.run(601);
    EXPECT_NEAR(scene.at(planet).x, 2e-3 * 100 / 2, 2e-4);
}

TEST_P(Sleep, WithoutForcesNothingMovesAndTheEngineSleeps) {
    Scene scene;
    scene.gravity = 0;
    scene.ball({0, 0});
    scene.run(60);
    EXPECT_EQ(scene.dynamics(), Activity::asleep);
}

TEST_P(Sleep, CanBeForbidden) {
    Scene scene({.solver = {.sleeping = false}});
    scene.fixed("floor", boxPiece(20, 1), {0, -0.5});
    scene.body("box", boxPiece(0.5, 0.5), {0, 0.26});
    scene.run(300);
    EXPECT_EQ(scene.dynamics(), Activity::active);
}

TEST_P(Sleep, ARemovedJointWakesItsBodies) {
    Scene scene;
    ObjectId const weight = scene.ball({0, -1});
    Joint joint;
    joint.form = JointForm::rope;
    joint.a = weight;
    joint.at = {0, -1};
    ObjectId const rope = scene.joint("rope", joint);
    scene.run(200);
    ASSERT_EQ(scene.dynamics(), Activity::asleep);
    scene.world->feed({.kind = PlayerInput::Kind::remove, .object = rope, .other = {}, .at = {}});
    scene.run(62);
    EXPECT_LT(scene.at(weight).y, -4);
}

} // namespace
} // namespace trembler::test
