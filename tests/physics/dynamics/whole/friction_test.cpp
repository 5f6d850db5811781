// Sliding and colliding, against Coulomb's law and the conservation laws.
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

class FrictionTest : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(FrictionTest);
class Collision : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Collision);

// The distance slid between two times down a slope with this ratio of tangent to friction, and the
// acceleration.
struct Slide {
    double way = 0;
    double acceleration = 0;
};

Slide slide(double angle, double frictionA, double frictionB) {
    Scene scene;
    ObjectId const slope = scene.fixed("slope", boxPiece(60, 1), rotated({0, -0.5}, angle), angle);
    ObjectId const block = scene.body("block", boxPiece(0.8, 0.2), rotated({20, 0.103}, angle), angle);
    scene.give(slope, Friction{frictionA});
    scene.give(block, Friction{frictionB});
    Vec2 const down = -rotated({1, 0}, angle);
    scene.run(30); // settles on the slope
    Vec2 const start = scene.at(block);
    double const before = dot(scene.velocity(block), down);
    scene.run(60);
    return {dot(scene.at(block) - start, down), dot(scene.velocity(block), down) - before};
}

TEST_P(FrictionTest, SlidesIfAndOnlyIfTheSlopeIsSteeperThanTheFriction) {
    for (double const friction : {0.2, 0.5, 0.9}) {
        double const still = std::atan(0.95 * friction);
        EXPECT_LT(slide(still, friction, friction).way, 2e-3) << friction;
        double const sliding = std::atan(1.05 * friction);
        double const g = 9.81 * (std::sin(sliding) - friction * std::cos(sliding));
        EXPECT_NEAR(slide(sliding, friction, friction).acceleration, g, 0.02 * g + 0.002) << friction;
    }
}

TEST_P(FrictionTest, AccelerationIsReducedByFrictionAndAPairHasTheGeometricMean) {
    double const angle = 0.6;
    double const friction = std::sqrt(0.8 * 0.2);
    double const expected = 9.81 * (std::sin(angle) - friction * std::cos(angle));
    EXPECT_NEAR(slide(angle, 0.8, 0.2).acceleration, expected, 0.01 * expected);
    EXPECT_NEAR(slide(angle, 0, 1).acceleration, 9.81 * std::sin(angle), 0.01 * 9.81 * std::sin(angle));
}

TEST_P(Collision, ElasticHeadOn) {
    for (double const ratio : {0.1, 1.0, 5.0}) {
        Scene scene;
        scene.gravity = 0;
        ObjectId const a = scene.ball({-1, 0});
        ObjectId const b = scene.ball({1, 0});
        scene.give(a, Mass{1});
        scene.give(b, Mass{ratio});
        scene.give(a, Restitution{1});
        scene.give(a, Velocity{{3, 0}});
        scene.give(b, Velocity{{-2, 0}});
        scene.run(120);
        double const centre =
            (3 - 2 * ratio) / (1 + ratio); // relative to the common velocity, velocities are reversed
        EXPECT_NEAR(scene.velocity(a).x, 2 * centre - 3, 1e-4) << ratio;
        EXPECT_NEAR(scene.velocity(b).x, 2 * centre + 2, 1e-4) << ratio;
    }
}

TEST_P(Collision, AGasKeepsItsMomentumAndItsEnergy) {
    Scene scene;
    scene.gravity = 0;
    std::vector<ObjectId> balls;
    for (int i = 0; i < 40; ++i) {
        Vec2 const at{0.5 * (i % 8) - 1.75, 0.5 * (i / 8) - 1};
        ObjectId const ball = scene.ball(at, 0.05 + 0.003 * i);
        scene.give(ball, Restitution{1});
        scene.give(ball, Friction{0});
        scene.give(ball, Velocity{Vec2{std::sin(i * 1.7), std::cos(i * 2.9)} - 2 * at}); // inwards
        balls.push_back(ball);
    }
    auto const totals = [&] {
        std::pair<Vec2, double> sum;
        for (ObjectId const ball : balls) {
            sum.first += scene.mass(ball) * scene.velocity(ball);
            sum.second += scene.mass(ball) * lengthSquared(scene.velocity(ball)) / 2;
        }
        return sum;
    };
    scene.run(1);
    auto const [momentum, energy] = totals();
    std::size_t hits = 0;
    for (int frame = 0; frame < 300; ++frame) {
        scene.run(1);
        hits += scene.contacts().begun.size() + scene.contacts().brief.size();
    }
    auto const [after, energyAfter] = totals();
    EXPECT_GT(hits, 20U);
    EXPECT_NEAR(length(after - momentum), 0, 1e-3);
    // Hits below 0.25 m/s do not bounce (Box2D's threshold), so a little energy may be lost, but none may be
    // gained.
    EXPECT_LT(energyAfter, energy * (1 + 1e-4));
    EXPECT_GT(energyAfter, energy * 0.99);
}

TEST_P(Collision, BouncesToTheSquareOfItsRestitution) {
    Scene scene;
    ObjectId const floor = scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
    ObjectId const ball = scene.ball({0, 2.1});
    scene.give(floor, Restitution{0.1});
    scene.give(ball, Restitution{0.8}); // a pair has the larger one
    double highest = 0;
    bool bounced = false;
    for (int frame = 0; frame < 110; ++frame) {
        scene.run(1);
        bounced = bounced || scene.velocity(ball).y > 0;
        highest = bounced ? std::max(highest, scene.at(ball).y - 0.1) : 0;
    }
    EXPECT_NEAR(highest, 2 * 0.8 * 0.8, 0.05);
}

TEST_P(Collision, GroupsDetermineWhichBodiesCollide) {
    struct Case {
        CollisionGroups a;
        CollisionGroups b;
        bool hits;
    };
    std::vector<Case> const cases{{{1, 0xffff, 0}, {1, 0xffff, 0}, true}, {{2, 4, 0}, {4, 2, 0}, true},
                                  {{2, 4, 0}, {4, 1, 0}, false},          {{2, 1, 0}, {4, 2, 0}, false},
                                  {{1, 1, -3}, {1, 1, -3}, false},        {{2, 0, 3}, {4, 0, 3}, true},
                                  {{1, 1, -3}, {1, 1, -4}, true}};
    for (Case const& c : cases) {
        Scene scene;
        scene.gravity = 0;
        ObjectId const a = scene.ball({0, 0});
        ObjectId const b = scene.ball({0.15, 0});
        scene.give(a, c.a);
        scene.give(b, c.b);
        scene.run(2);
        EXPECT_EQ(scene.touching(a, b), c.hits);
    }
}

// A movable wall of a decimetre, at a hundred metres per second: a test of positions alone would miss the
// impact.
TEST_P(Collision, BulletsHitThinMovableBodies) {
    int passed[2] = {0, 0};
    for (int const bullet : {0, 1}) {
        for (int phase = 0; phase < 24; ++phase) {
            Scene scene({.solver = {.substeps = 2}});
            scene.gravity = 0;
            ObjectId const ball = scene.body("ball", circlePiece(0.05), {-2 - 0.02 * phase, 0});
            ObjectId const wall = scene.body("wall", boxPiece(0.1, 2), {0, 0});
            scene.give(wall, Density{5000});
            scene.give(ball, Velocity{{50, 0}});
            if (bullet == 1) {
                scene.give(ball, Bullet{});
            }
            scene.run(20);
            passed[bullet] += scene.at(ball).x > scene.at(wall).x ? 1 : 0;
        }
    }
    if (on("native")) { // there every body is a bullet
        EXPECT_EQ(passed[0], 0);
    } else {
        EXPECT_GT(passed[0], 6);
    }
    EXPECT_EQ(passed[1], 0);
}

TEST_P(Collision, NothingPassesThroughFixedBodies) {
    for (int phase = 0; phase < 20; ++phase) {
        Scene scene;
        scene.gravity = 0;
        scene.fixed("wall", boxPiece(0.02, 4), {0, 0});
        ObjectId const ball = scene.body("ball", circlePiece(0.03), {-2 - 0.02 * phase, 0});
        scene.give(ball, Velocity{{100, 0}});
        scene.run(30);
        EXPECT_LT(scene.at(ball).x, 0);
    }
}

} // namespace
} // namespace trembler::test
