#include "physics/depth.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace motion_test {
namespace {

class Motion : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Motion);

// Semi-implicit Euler (v += h g, then x += h v) is exact in v and falls ahead in x by g h t / 2; Chipmunk
// does it the other way round, and lags as much. Calls of interactions are carried out in the next frame, so
// the first frame has no gravity yet.
TEST_P(Motion, ProjectileFollowsTheParabolaOfItsIntegrator) {
    for (int const substeps : {1, 4, 16}) {
        Scene scene({.solver = {.substeps = substeps}});
        ObjectId const ball = scene.ball({0, 0});
        scene.give(ball, Velocity{{7, 9}});
        double const h = frameDuration / substeps;
        scene.run(1);
        EXPECT_NEAR(scene.at(ball).y, 9 * frameDuration, 1e-5);
        for (int frame = 1; frame <= 120; ++frame) {
            scene.run(1);
            double const t = frame * frameDuration;
            double const ahead = on("native") ? 0 : on("chipmunk") ? -1 : 1; // of the integrator, in steps
            double const y = 9 * (t + frameDuration) - 9.81 * t * t / 2 - ahead * 9.81 * h * t / 2;
            ASSERT_NEAR(scene.at(ball).x, 7 * (t + frameDuration), 5e-4);
            ASSERT_NEAR(scene.at(ball).y, y, 5e-4) << substeps << " substeps, t = " << t;
            ASSERT_NEAR(scene.velocity(ball).y, 9 - 9.81 * t, 5e-4);
        }
    }
}

TEST_P(Motion, MassFollowsFromDensityOrIsStated) {
    Scene scene;
    ObjectId const plain = scene.body("plain", boxPiece(0.5, 0.2), {0, 0});
    ObjectId const steel = scene.body("steel", circlePiece(0.1), {5, 0});
    scene.give(steel, Density{7850});
    ObjectId const stated = scene.body("stated", circlePiece(0.1), {10, 0});
    scene.give(stated, Mass{3});
    ObjectId const floor = scene.fixed("floor", boxPiece(1, 1), {0, -9});
    scene.run(1);
    EXPECT_DOUBLE_EQ(scene.mass(plain), 1000 * 0.5 * 0.2 * worldDepth);
    EXPECT_DOUBLE_EQ(scene.mass(steel), 7850 * pi * 0.01 * worldDepth);
    EXPECT_EQ(scene.mass(stated), 3);
    EXPECT_DOUBLE_EQ(scene.mass(floor), 1000 * worldDepth) << "a fixed body has a mass that others can read";
    EXPECT_EQ(scene.world->find<Velocity>(floor), nullptr) << "but nothing moves it";
    EXPECT_EQ(scene.at(floor), (Vec2{0, -9}));
    EXPECT_NE(scene.world->find<Rotation>(floor), nullptr);
}

TEST_P(Motion, TorqueTurnsByTheMomentOfInertia) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const box = scene.body("box", boxPiece(0.6, 0.2), {1, 2});
    scene.give(box, Mass{3});
    Pull pull;
    pull.torque = 0.4;
    scene.give(box, pull);
    scene.run(61);
    double const inertia = 3 * (0.6 * 0.6 + 0.2 * 0.2) / 12;
    EXPECT_NEAR(scene.spin(box), 0.4 / inertia, 1e-3);
    EXPECT_NEAR(scene.angle(box), 0.4 / inertia / 2, 0.01);
    EXPECT_NEAR(length(scene.at(box) - Vec2{1, 2}), 0, 1e-6);
}

TEST_P(Motion, AnEccentricForceAlsoTurns) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const disc = scene.body("disc", circlePiece(0.5), {0, 0});
    scene.give(disc, Mass{2});
    Pull pull;
    pull.point = {0, 0.5};
    pull.pointForce = {1, 0};
    scene.give(disc, pull);
    scene.run(2);
    // one frame: v = F t / m, w = -r F t / I with I = m r^2 / 2
    EXPECT_NEAR(scene.velocity(disc).x, 1 * frameDuration / 2, 1e-6);
    EXPECT_NEAR(scene.spin(disc), -0.5 * frameDuration / (2 * 0.25 / 2), 1e-4);
}

TEST_P(Motion, AnImpulseActsOnce) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const disc = scene.body("disc", circlePiece(0.5), {0, 0});
    scene.give(disc, Mass{2});
    scene.give(disc, Kick{{3, 0}, {0, 0.25}, 1});
    scene.run(2);
    for (int frame = 0; frame < 10; ++frame) {
        EXPECT_NEAR(scene.velocity(disc).x, 1.5, 1e-6);
        EXPECT_NEAR(scene.spin(disc), -0.25 * 3 / 0.25, 1e-5);
        scene.run(1);
    }
    scene.of<Kick>(disc) = {{-3, 0}, scene.at(disc) + Vec2{0, 0.25}, 2};
    scene.run(3);
    EXPECT_NEAR(scene.velocity(disc).x, 0, 1e-5);
}

TEST_P(Motion, DampingFollowsItsExponential) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const ball = scene.ball({0, 0});
    scene.give(ball, Velocity{{4, 0}});
    scene.give(ball, AngularVelocity{5});
    scene.give(ball, Damping{0.5, 1.5});
    scene.run(60);
    EXPECT_NEAR(scene.velocity(ball).x, 4 * std::exp(-0.5), 4e-3); // implicit in v: (1 + c h)^-n
    EXPECT_NEAR(scene.spin(ball), 5 * std::exp(-1.5), 2e-2);
}

// An L of two boxes; the origin of its frame is the corner, its centre of mass is not.
TEST_P(Motion, ACompoundTurnsAboutItsCentreOfMass) {
    Scene scene;
    scene.gravity = 0;
    Shape const shape{{boxPiece(0.2, 1, {0, 0.5}), boxPiece(0.6, 0.2, {0.4, 0.1})}};
    Vec2 const centre = (0.2 * Vec2{0, 0.5} + 0.12 * Vec2{0.4, 0.1}) / 0.32;
    ObjectId const bracket = scene.body("bracket", shape, {3, 4}, 0.7);
    Pull pull;
    pull.torque = 1;
    scene.give(bracket, pull);
    Vec2 const at = scene.at(bracket) + rotated(centre, 0.7);
    for (int frame = 0; frame < 120; ++frame) {
        scene.run(1);
        ASSERT_NEAR(length(scene.at(bracket) + rotated(centre, scene.angle(bracket)) - at), 0, 1e-5);
        ASSERT_NEAR(length(scene.velocity(bracket)), 0, 1e-6); // velocity is that of the centre of mass
    }
    EXPECT_GT(scene.angle(bracket), 1);
    scene.of<Pull>(bracket) = {};
    scene.of<Pull>(bracket).force = {0, 2};
    double const spin = scene.spin(bracket);
    scene.run(30);
    EXPECT_NEAR(scene.spin(bracket), spin + 1 * frameDuration * 0, 0.2);
    double const steady = scene.spin(bracket);
    scene.run(30);
    EXPECT_NEAR(scene.spin(bracket), steady, 1e-5); // a force at the centre of mass turns nothing
}

TEST_P(Motion, ExcessiveForcesAreLimitedAndTheWorldContinues) {
    Scene scene({.trace = true});
    ObjectId const ball = scene.ball({0, 0});
    ObjectId const other = scene.ball({3, 0});
    Pull pull;
    pull.force = {1e300, 0};
    pull.torque = -1e300;
    scene.give(ball, pull);
    pull.force = {std::nan(""), 1};
    pull.torque = 0;
    scene.give(other, pull);
    scene.give(ball, Kick{{1e300, -1e300}, {1e9, 0}, 1});
    scene.run(60);
    EXPECT_TRUE(isFinite(scene.at(ball)));
    EXPECT_TRUE(isFinite(scene.velocity(ball)));
    EXPECT_TRUE(std::isfinite(scene.angle(ball)));
    EXPECT_EQ(scene.at(other), (Vec2{3, 0}));
    bool reported = false;
    for (Event const& event : scene.world->tracer()->events()) {
        reported = reported || event.event == "refused: the force is not a finite number";
    }
    EXPECT_TRUE(reported);
}

} // namespace
} // namespace motion_test
} // namespace trembler::test
