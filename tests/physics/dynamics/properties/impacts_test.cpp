// Impacts compared with the conservation of momentum.
#include "physics/dynamics/properties/impacts.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace trembler {
namespace {

using test::engines;
using test::OnEveryEngine;
using test::Scene;

class ImpactsTest : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(ImpactsTest);

std::vector<Impact> impactsIn(Scene& scene, int frames) {
    std::vector<Impact> all;
    for (int i = 0; i < frames; ++i) {
        scene.run(1);
        auto const& impacts = scene.world->find<Impacts>()->impacts;
        all.insert(all.end(), impacts.begin(), impacts.end());
    }
    return all;
}

TEST_P(ImpactsTest, AreNotComputedWithoutReaders) {
    Scene scene;
    scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
    scene.ball({0, 1});
    EXPECT_TRUE(impactsIn(scene, 120).empty());
}

TEST_P(ImpactsTest, ABouncingBallGetsTheImpulseThatReversesIt) {
    Scene scene;
    Subscription const wantedImpacts = scene.world->want<Impacts>();
    ObjectId const floor = scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
    ObjectId const ball = scene.ball({0, 2});
    scene.give(ball, Restitution{0.8});
    Vec2 before;
    std::vector<Impact> impacts;
    while (impacts.empty()) {
        if (scene.world->frame() > 0) {
            before = scene.velocity(ball);
        }
        impacts = impactsIn(scene, 1);
        ASSERT_LT(scene.world->frame(), 200U);
    }
    ASSERT_EQ(impacts.size(), 1U);
    double const gained = scene.mass(ball) * (scene.velocity(ball).y - before.y + scene.gravity / 60);
    EXPECT_NEAR(impacts[0].impulse, gained, 0.01 * gained);
    EXPECT_EQ(std::min(floor, ball), impacts[0].a);
    EXPECT_EQ(std::max(floor, ball), impacts[0].b);
    EXPECT_NEAR(std::abs(impacts[0].normal.y), 1, 1e-3);
    EXPECT_NEAR(impacts[0].point.y, 0, 0.02);
    EXPECT_GE(impacts[0].since, 0);
    EXPECT_LT(impacts[0].since, 1.0 / 60);
}

TEST_P(ImpactsTest, TwoBallsThatMeetInTheAirShareOneImpact) {
    Scene scene;
    scene.gravity = 0;
    Subscription const wantedImpacts = scene.world->want<Impacts>();
    ObjectId const left = scene.ball({-1, 0});
    ObjectId const right = scene.ball({1, 0}, 0.15);
    scene.give(left, Velocity{{3, 0}});
    scene.give(right, Velocity{{-1, 0}});
    scene.give(left, Restitution{1});
    std::vector<Impact> const impacts = impactsIn(scene, 120);
    ASSERT_EQ(impacts.size(), 1U);
    // Elastic: 2 μ v, μ the reduced mass, v the speed of approach.
    double const reduced = 1 / (1 / scene.mass(left) + 1 / scene.mass(right));
    EXPECT_NEAR(impacts[0].impulse, 2 * reduced * 4, 0.01 * reduced);
}

TEST_P(ImpactsTest, AConstantForceIsNoImpact) {
    Scene scene;
    Subscription const wantedImpacts = scene.world->want<Impacts>();
    scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
    for (int i = 0; i < 8; ++i) {
        scene.body("box " + std::to_string(i), boxPiece(0.5, 0.5), {0, 0.25 + 0.5 * i});
    }
    impactsIn(scene, 30); // they settle
    EXPECT_TRUE(impactsIn(scene, 300).empty());
}

double kineticEnergy(Scene const& scene, ObjectId id) {
    Shape const& shape = *scene.world->find<Shape>(id);
    double const inertia = scene.mass(id) * massPropertiesOf(shape).inertiaPerMass;
    return 0.5 *
           (scene.mass(id) * lengthSquared(scene.velocity(id)) + inertia * scene.spin(id) * scene.spin(id));
}

TEST_P(ImpactsTest, PartsThatBeginInContactDoNotCollide) {
    for (double const overlap : {0.0, 0.002, 0.03}) {
        Scene scene;
        Subscription const wantedImpacts = scene.world->want<Impacts>();
        ObjectId const floor = scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
        for (int i = 0; i < 6; ++i) {
            scene.body("box " + std::to_string(i), boxPiece(0.5, 0.5), {0, 0.25 + (0.5 - overlap) * i});
        }
        scene.body("beside", boxPiece(0.5, 0.5), {0.5 - overlap, 0.25});
        scene.run(1);
        double lightest = 1e9;
        for (ObjectId const id : scene.world->store().column<Mass>().owners()) {
            lightest = id == floor ? lightest : std::min(lightest, scene.mass(id));
        }
        for (Impact const& impact : scene.world->find<Impacts>()->impacts) {
            EXPECT_LT(impact.impulse, 0.5 * lightest) << overlap; // none reverses 25 cm/s
        }
    }
}

// A motor of great strength turns a bar against a fixed block, and presses for ever.
TEST_P(ImpactsTest, ABlockedMotorHitsOnceAndThenPresses) {
    Scene scene;
    scene.gravity = 0;
    Subscription const wantedImpacts = scene.world->want<Impacts>();
    ObjectId const bar = scene.body("bar", boxPiece(1, 0.1), {0, 0});
    scene.fixed("block", boxPiece(0.1, 0.1), {0.45, 0.2});
    Joint joint;
    joint.a = bar;
    joint.motor = true;
    joint.motorSpeed = 0.5;
    joint.motorStrength = 1e4;
    scene.joint("axle", joint);
    std::vector<Impact> const impacts = impactsIn(scene, 120);
    ASSERT_FALSE(impacts.empty()) << "it arrives at 0.5 rad/s";
    Shape const& shape = *scene.world->find<Shape>(bar);
    double const inertia = scene.mass(bar) * massPropertiesOf(shape).inertiaPerMass;
    double const energy = 0.5 * inertia * 0.5 * 0.5;
    double const arm = 0.45;
    for (Impact const& impact : impacts) {
        double const inverse = 1 / scene.mass(bar) + arm * arm / inertia;
        EXPECT_LT(impact.impulse * impact.impulse * inverse / 2, 5 * energy)
            << "the motor's strength is no impact";
    }
    EXPECT_TRUE(impactsIn(scene, 120).empty()) << "a pressure";
}

// Bodies fall, overlap at the start, are tied by joints that do not fit and driven by motors: no impact has
// more energy than there was in the world at the beginning of its frame, plus what forces and motors added.
TEST_P(ImpactsTest, NoneExceedsTheEnergyThatWasThere) {
    for (unsigned seed = 0; seed < 6; ++seed) {
        std::mt19937 random(seed);
        auto const between = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random() >> 8U) * 0x1p-24;
        };
        Scene scene;
        Subscription const wantedImpacts = scene.world->want<Impacts>();
        scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
        std::vector<ObjectId> bodies;
        for (int i = 0; i < 8; ++i) {
            Vec2 const at{between(-0.6, 0.6), between(0.1, 1.2)};
            bodies.push_back(i % 2 == 0 ? scene.ball(at, between(0.05, 0.2))
                                        : scene.body("box " + std::to_string(i),
                                                     boxPiece(between(0.1, 0.5), between(0.1, 0.5)), at,
                                                     between(0, 3)));
        }
        double motors = 0; // J per second at most
        for (int i = 0; i < 2; ++i) {
            Joint joint;
            joint.a = bodies[static_cast<std::size_t>(i)];
            joint.at = scene.at(joint.a);
            joint.motor = true;
            joint.motorSpeed = between(-3, 3);
            joint.motorStrength = between(1, 50);
            motors += joint.motorStrength * std::abs(joint.motorSpeed);
            scene.joint("motor " + std::to_string(i), joint);
        }
        for (int frame = 0; frame < 60; ++frame) {
            double energy = 0;
            std::vector<double> speeds;
            for (ObjectId const id : bodies) {
                energy += frame == 0 ? 0 : kineticEnergy(scene, id);
                speeds.push_back(frame == 0 ? 0 : length(scene.velocity(id)));
            }
            scene.run(1);
            double fall = 0; // what gravity can have added
            for (std::size_t i = 0; i < bodies.size(); ++i) {
                fall += scene.mass(bodies[i]) * scene.gravity * (speeds[i] + scene.gravity / 60) / 60;
            }
            double const there = energy + fall + motors / 60;
            for (Impact const& impact : scene.world->find<Impacts>()->impacts) {
                double inverse = 0;
                for (ObjectId const id : {impact.a, impact.b}) {
                    bool const moves = std::find(bodies.begin(), bodies.end(), id) != bodies.end();
                    inverse += moves ? 1 / scene.mass(id) : 0;
                }
                EXPECT_LE(impact.impulse * impact.impulse * inverse / 2, 4 * there * 1.05 + 1e-9)
                    << "seed " << seed << ", frame " << frame;
            }
        }
    }
}

TEST_P(ImpactsTest, LaterReadersGetOnlyNewImpacts) {
    Scene scene;
    scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
    scene.body("box", boxPiece(0.5, 0.5), {0, 0.25});
    DynamicsSettings settings;
    settings.sleeping = false;
    scene.give(scene.world->store().find("world"), settings);
    scene.run(60);
    Subscription const wantedImpacts = scene.world->want<Impacts>();
    EXPECT_TRUE(impactsIn(scene, 60).empty()) << "the box lies at rest";
    ObjectId const ball = scene.ball({0, 2});
    test::Pull weight;
    weight.acceleration = {0, -9.81};
    scene.give(ball, weight);
    scene.world->store().complete(ball);
    EXPECT_FALSE(impactsIn(scene, 120).empty());
}

TEST_P(ImpactsTest, SubscribingChangesNoBit) {
    auto const hashes = [](bool wanted) {
        Scene scene;
        Subscription impacts;
        if (wanted) {
            impacts = scene.world->want<Impacts>();
        }
        scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
        for (int i = 0; i < 12; ++i) {
            ObjectId const id = i % 2 == 0 ? scene.ball({0.1 * i, 1 + 0.4 * i})
                                           : scene.body("box " + std::to_string(i), boxPiece(0.3, 0.2),
                                                        {0.05 * i, 1 + 0.4 * i}, 0.2 * i);
            scene.give(id, Restitution{0.5});
            scene.give(id, Bullet{});
        }
        std::vector<std::uint64_t> all;
        for (int i = 0; i < 240; ++i) {
            scene.run(1);
            all.push_back(scene.world->stateHash());
        }
        return all;
    };
    EXPECT_EQ(hashes(true), hashes(false));
}

} // namespace
} // namespace trembler
