// Impacts compared with the conservation of momentum.
#include "physics/dynamics/properties/impacts.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
