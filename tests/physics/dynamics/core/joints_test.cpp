// Every kind of joint keeps its constraint.
#include "physics/dynamics/properties/motion_causes.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

class Hinge : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Hinge);
class Weld : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Weld);
class Slider : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Slider);
class Distance : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Distance);
class Rope : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Rope);
class Pulley : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Pulley);
class Gear : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Gear);
class Wheel : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Wheel);
class Joints : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Joints);

Joint jointOf(JointForm form, ObjectId a, ObjectId b, Vec2 at) {
    Joint joint;
    joint.form = form;
    joint.a = a;
    joint.b = b;
    joint.at = at;
    return joint;
}

Vec2 pointOf(Scene const& scene, ObjectId id, Vec2 local) {
    return scene.at(id) + rotated(local, scene.angle(id));
}

TEST_P(Hinge, HoldsTheLinksOfAChainTogether) {
    Scene scene;
    std::vector<ObjectId> links;
    for (int i = 0; i < 12; ++i) {
        links.push_back(scene.body("link " + std::to_string(i), capsulePiece(0.5, 0.05), {0.4 * i + 0.2, 0}));
        scene.joint("pin " + std::to_string(i),
                    jointOf(JointForm::hinge, links.back(), i == 0 ? ObjectId{} : links[links.size() - 2],
                            {0.4 * i, 0}));
    }
    double worst = 0;
    for (int frame = 0; frame < 300; ++frame) {
        scene.run(1);
        worst = std::max(worst, length(pointOf(scene, links[0], {-0.2, 0})));
        for (std::size_t i = 1; i < links.size(); ++i) {
            worst = std::max(
                worst, length(pointOf(scene, links[i], {-0.2, 0}) - pointOf(scene, links[i - 1], {0.2, 0})));
        }
    }
    // The other engines correct position errors less thoroughly: docs/engines.md.
    EXPECT_LT(worst, on("box2d") ? 3e-3 : on("chipmunk") ? 8e-3 : 15e-3);
    EXPECT_LT(scene.at(links.back()).y, -1); // it must have swung
}

TEST_P(Hinge, MotorReachesItsSpeedInItsDirection) {
    for (double const speed : {3.0, -7.0}) {
        Scene scene;
        ObjectId const disc = scene.body("disc", circlePiece(0.3), {1, 1});
        Joint joint = jointOf(JointForm::hinge, disc, {}, {1, 1});
        joint.motor = true;
        joint.motorSpeed = speed;
        joint.motorStrength = 100;
        scene.joint("axle", joint);
        scene.run(120);
        EXPECT_NEAR(scene.spin(disc), speed, 1e-3);
        EXPECT_EQ(scene.dynamics(), Activity::active); // a running motor never falls asleep, however slow
    }
}

TEST_P(Hinge, MotorTorqueIsLimitedToItsStrength) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const disc = scene.body("disc", circlePiece(0.3), {0, 0});
    Joint joint = jointOf(JointForm::hinge, disc, {}, {0, 0});
    joint.motor = true;
    joint.motorSpeed = 1000;
    joint.motorStrength = 0.5;
    scene.joint("axle", joint);
    scene.run(60);
    EXPECT_NEAR(scene.spin(disc), 0.5 / (scene.mass(disc) * 0.09 / 2), 0.01);
}

TEST_P(Hinge, AVerySlowMotorIsNotTakenForRest) {
    Scene scene;
    ObjectId const disc = scene.body("hand of a clock", circlePiece(0.3), {0, 0});
    Joint joint = jointOf(JointForm::hinge, disc, {}, {0, 0});
    joint.motor = true;
    joint.motorSpeed = -0.01; // rad/s, a third of Box2D's tolerance
    joint.motorStrength = 10;
    scene.joint("axle", joint);
    scene.run(600);
    EXPECT_NEAR(scene.angle(disc), -0.1, 2e-3);
}

TEST_P(Hinge, LimitsStopItOnBothSides) {
    Scene scene;
    ObjectId const door = scene.body("door", boxPiece(1, 0.1), {0.5, 0});
    Joint joint = jointOf(JointForm::hinge, door, {}, {0, 0});
    joint.limited = true;
    joint.lower = -0.8;
    joint.upper = 0.3;
    scene.joint("pin", joint);
    double least = 0;
    for (int frame = 0; frame < 200; ++frame) {
        scene.run(1);
        least = std::min(least, scene.angle(door));
    }
    EXPECT_NEAR(scene.angle(door), -0.8, 0.01);
    EXPECT_GT(least, -0.83);
    scene.of<Pull>(door).acceleration = {0, 9.81};
    scene.run(200);
    EXPECT_NEAR(scene.angle(door), 0.3, 0.01);
}

TEST_P(Hinge, AngleIsCountedFromTheInitialPoseAndRelativeToB) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const base = scene.body("base", boxPiece(1, 1), {0, 0}, 1.2);
    ObjectId const arm = scene.body("arm", boxPiece(1, 0.1), {0, 0}, -0.4);
    scene.give(base, Mass{1e6});
    Joint joint = jointOf(JointForm::hinge, arm, base, {0, 0});
    joint.limited = true;
    joint.lower = -0.1;
    joint.upper = 0.5;
    joint.motor = true;
    joint.motorSpeed = 2;
    joint.motorStrength = 10;
    scene.joint("pin", joint);
    scene.run(120);
    EXPECT_NEAR(scene.angle(arm) - scene.angle(base), -0.4 - 1.2 + 0.5, 0.01);
}

TEST_P(Weld, KeepsTwoBodiesInTheSamePose) {
    Scene scene;
    ObjectId const a = scene.body("a", boxPiece(0.4, 0.2), {0, 0}, 0.3);
    ObjectId const b = scene.body("b", circlePiece(0.15), {0.35, 0.1});
    scene.joint("weld", jointOf(JointForm::weld, a, b, {0.2, 0.05}));
    scene.give(a, AngularVelocity{6});
    scene.give(a, Velocity{{2, 5}});
    Vec2 const offset = rotated(scene.at(b) - scene.at(a), -0.3);
    for (int frame = 0; frame < 120; ++frame) {
        scene.run(1);
        Vec2 const now = rotated(scene.at(b) - scene.at(a), -scene.angle(a));
        ASSERT_NEAR(length(now - offset), 0, 2e-3);
        ASSERT_NEAR(scene.angle(b) - scene.angle(a), -0.3, 5e-3);
    }
    EXPECT_GT(std::abs(scene.angle(a)), 4);
}

TEST_P(Slider, MovesAlongItsAxisOnly) {
    double const slope = -0.5;
    Scene scene;
    ObjectId const cart = scene.body("cart", boxPiece(0.4, 0.2), {0, 0});
    Joint joint = jointOf(JointForm::slider, cart, {}, {0, 0});
    joint.axis = rotated({3, 0}, slope); // its length does not matter
    scene.joint("rail", joint);
    for (int frame = 0; frame <= 90; ++frame) {
        scene.run(1);
        Vec2 const along = rotated(scene.at(cart), -slope);
        ASSERT_NEAR(along.y, 0, 1e-3);
        ASSERT_NEAR(scene.angle(cart), 0, 1e-3);
    }
    double const t = 90 * frameDuration;
    EXPECT_NEAR(dot(scene.velocity(cart), rotated({1, 0}, slope)), 9.81 * std::sin(0.5) * t, 0.01);
}

TEST_P(Slider, LimitsMotorAndStrength) {
    Scene scene;
    ObjectId const lift = scene.body("lift", boxPiece(0.4, 0.2), {0, 0});
    scene.give(lift, Mass{5});
    Joint joint = jointOf(JointForm::slider, lift, {}, {0, 0});
    joint.axis = {0, 1};
    joint.limited = true;
    joint.lower = -0.5;
    joint.upper = 1;
    joint.motor = true;
    joint.motorSpeed = 0.8;
    joint.motorStrength = 5 * 9.81 * 1.2;
    ObjectId const rail = scene.joint("rail", joint);
    scene.run(60);
    EXPECT_NEAR(scene.velocity(lift).y, 0.8, 1e-3);
    scene.run(120);
    EXPECT_NEAR(scene.at(lift).y, 1, 5e-3);
    scene.of<Joint>(rail).motorStrength = 5 * 9.81 * 0.8; // a change in a running world
    scene.run(240);
    EXPECT_NEAR(scene.at(lift).y, -0.5, 5e-3);
}

TEST_P(Distance, KeepsItsLengthWhileSwinging) {
    Scene scene;
    ObjectId const a = scene.ball({1, 0});
    ObjectId const b = scene.ball({2, 0});
    Joint joint = jointOf(JointForm::distance, a, {}, {1, 0});
    scene.joint("rod", joint);
    joint = jointOf(JointForm::distance, b, a, {2, 0});
    joint.atB = {1, 0};
    scene.joint("rod 2", joint);
    for (int frame = 0; frame < 300; ++frame) {
        scene.run(1);
        ASSERT_NEAR(length(scene.at(a)), 1, 2e-3);
        ASSERT_NEAR(length(scene.at(b) - scene.at(a)), 1, 2e-3);
    }
}

TEST_P(Distance, TakesOnAStatedLength) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const a = scene.ball({1, 0});
    Joint joint = jointOf(JointForm::distance, a, {}, {1, 0});
    joint.length = 1.5;
    scene.joint("rod", joint);
    scene.run(120);
    EXPECT_NEAR(length(scene.at(a)), 1.5, 2e-3);
}

TEST_P(Rope, IsSlackUntilItIsTaut) {
    Scene scene;
    ObjectId const weight = scene.ball({0.2, 0});
    Joint joint = jointOf(JointForm::rope, weight, {}, {0.2, 0});
    joint.length = 1.5;
    scene.joint("rope", joint);
    scene.run(20);
    double const t = 19 * frameDuration; // falls freely
    EXPECT_NEAR(scene.at(weight).y, -9.81 * t * t / 2, 0.02);
    double longest = 0;
    for (int frame = 0; frame < 300; ++frame) {
        scene.run(1);
        longest = std::max(longest, length(scene.at(weight)));
    }
    EXPECT_LT(longest, 1.5 * 1.01);
    EXPECT_GT(longest, 1.5 * 0.999);
}

TEST_P(Pulley, KeepsTheSumOfItsRopesAndFallsLikeAtwoodsMachine) {
    for (double const ratio : {1.0, 2.0}) {
        Scene scene;
        ObjectId const a = scene.body("a", boxPiece(0.3, 0.3), {-1, -1});
        ObjectId const b = scene.body("b", boxPiece(0.3, 0.3), {1, -2});
        scene.give(a, Mass{3});
        scene.give(b, Mass{2});
        Joint joint = jointOf(JointForm::pulley, a, b, {-1, -1});
        joint.atB = {1, -2};
        joint.groundA = {-1, 0};
        joint.groundB = {1, 0};
        joint.ratio = ratio;
        scene.joint("pulley", joint);
        double const sum = 1 + ratio * 2;
        scene.run(1);
        for (int frame = 1; frame <= 30; ++frame) {
            scene.run(1);
            ASSERT_NEAR(length(scene.at(a) - joint.groundA) + ratio * length(scene.at(b) - joint.groundB),
                        sum, 5e-3);
        }
        // Tension T on a, ratio T on b, and the rope's ends keep a + ratio b: a falls with
        double const a1 = 9.81 * (3 * ratio * ratio - 2 * ratio) / (3 * ratio * ratio + 2);
        EXPECT_NEAR(scene.velocity(a).y, -a1 * 0.5, 0.02) << ratio;
        EXPECT_NEAR(scene.velocity(b).y, a1 / ratio * 0.5, 0.02) << ratio;
    }
}

TEST_P(Gear, CouplesTwoHinges) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const small = scene.body("small", circlePiece(0.2), {0, 0});
    ObjectId const large = scene.body("large", circlePiece(0.6), {1, 0});
    Joint joint = jointOf(JointForm::hinge, small, {}, {0, 0});
    joint.motor = true;
    joint.motorSpeed = 6;
    joint.motorStrength = 50;
    ObjectId const axleA = scene.joint("axle a", joint);
    ObjectId const axleB = scene.joint("axle b", jointOf(JointForm::hinge, large, {}, {1, 0}));
    Joint gear = jointOf(JointForm::gear, small, large, {});
    gear.jointA = axleA;
    gear.jointB = axleB;
    gear.ratio = 3; // turn of a + 3 * turn of b stays
    scene.joint("gear", gear);
    scene.run(240);
    EXPECT_NEAR(scene.spin(small), 6, 0.01);
    EXPECT_NEAR(scene.spin(large), -2, 0.01);
    EXPECT_NEAR(scene.angle(small) + 3 * scene.angle(large), 0, 0.02);
}

TEST_P(Gear, CouplesAHingeAndASliderAtAnyScale) {
    for (double const scale : {1.0, 4.0, 16.0}) {
        Scene scene({.solver = {.scale = scale}});
        scene.gravity = 0;
        ObjectId const wheel = scene.body("wheel", circlePiece(0.25), {0, 0});
        ObjectId const rack = scene.body("rack", boxPiece(2, 0.1), {0, -0.4});
        Joint joint = jointOf(JointForm::hinge, wheel, {}, {0, 0});
        joint.motor = true;
        joint.motorSpeed = 2;
        joint.motorStrength = 100;
        ObjectId const axle = scene.joint("a axle", joint);
        ObjectId const rail = scene.joint("rail", jointOf(JointForm::slider, rack, {}, {0, -0.4}));
        Joint gear = jointOf(JointForm::gear, wheel, rack, {});
        gear.jointA = axle;
        gear.jointB = rail;
        gear.ratio = -4; // angle - 4 * shift = 0: a wheel of 0.25 m rolls on the rack
        scene.joint("gear", gear);
        scene.run(120);
        EXPECT_NEAR(scene.velocity(rack).x, 0.5, 0.01) << scale;
        EXPECT_NEAR(scene.at(rack).x, scene.angle(wheel) / 4, 5e-3) << scale;
    }
}

TEST_P(Wheel, SagsOnItsSpringAndTurnsFreely) {
    for (double const scale : {1.0, 4.0}) {
        Scene scene({.solver = {.scale = scale}});
        ObjectId const wheel = scene.body("wheel", circlePiece(0.3), {0, 0});
        scene.give(wheel, Mass{4});
        Joint joint = jointOf(JointForm::wheel, wheel, {}, {0, 0});
        joint.axis = {0, 1};
        joint.stiffness = 400;
        joint.dampingRate = 80;
        joint.motor = true;
        joint.motorSpeed = -5;
        joint.motorStrength = 20;
        scene.joint("suspension", joint);
        scene.run(300);
        EXPECT_NEAR(scene.at(wheel).y, -4 * 9.81 / 400, 2e-3) << scale;
        EXPECT_NEAR(scene.at(wheel).x, 0, 1e-3) << scale;
        EXPECT_NEAR(scene.spin(wheel), -5, 0.01) << scale;
    }
}

TEST_P(Joints, JoinedObjectsCollideOnlyIfStated) {
    for (bool const collide : {false, true}) {
        Scene scene;
        scene.gravity = 0;
        ObjectId const a = scene.ball({0, 0});
        ObjectId const b = scene.ball({0.1, 0});
        Joint joint = jointOf(JointForm::rope, a, b, {0, 0});
        joint.atB = {0.1, 0};
        joint.length = 1;
        joint.collide = collide;
        scene.joint("rope", joint);
        scene.run(3);
        EXPECT_EQ(scene.touching(a, b), collide);
    }
}

} // namespace
} // namespace trembler::test
