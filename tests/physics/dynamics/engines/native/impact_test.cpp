// Impacts against the formulas of two bodies, Newton's cradle, and the height to which a ball rises.
#include "tests/physics/dynamics/engines/native/small_world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler::test {
namespace native_impact_test {
namespace {

constexpr double radius = 0.1;

double unit() {
    return *rc::gen::inRange(0, 1000001) / 1e6;
}

TEST(NativeImpacts, OfTwoDiscsAreThoseOfTheFormula) {
    EXPECT_TRUE(rc::check([] {
        double const e = unit();
        double const m1 = std::pow(10, 3 * unit() - 1);
        double const m2 = std::pow(10, 3 * unit() - 1);
        double const v1 = 0.1 + 20 * unit();
        double const v2 = -0.1 - 20 * unit();
        SmallWorld world(0);
        SlotIndex const a =
            world.add(discShape(radius), {.at = {-1, 0}, .velocity = {v1, 0}, .mass = m1, .restitution = e});
        SlotIndex const b = world.add(discShape(radius), {.at = {1, 0}, .velocity = {v2, 0}, .mass = m2});
        for (int i = 0; i < 60 * 10 && world.changes.empty(); ++i) {
            world.step();
        }
        world.step();
        double const common = (m1 * v1 + m2 * v2) / (m1 + m2);
        RC_ASSERT(std::abs(world.motions[a].velocity.x - (common - e * m2 / (m1 + m2) * (v1 - v2))) <
                  1e-6 * (v1 - v2));
        RC_ASSERT(std::abs(world.motions[b].velocity.x - (common + e * m1 / (m1 + m2) * (v1 - v2))) <
                  1e-6 * (v1 - v2));
    }));
}

// A disc that strikes another one aside pushes it along the line of their centres at that moment.
TEST(NativeImpacts, PushAlongTheLineOfCentresHoweverOblique) {
    EXPECT_TRUE(rc::check([] {
        double const aside = 1.9 * unit() * radius; // m, of its way from the other's centre
        double const speed = 0.5 + 30 * unit();
        SmallWorld world(0);
        world.add(discShape(radius),
                  {.at = {-1 - unit(), aside}, .velocity = {speed, 0}, .restitution = 1, .friction = 0});
        SlotIndex const struck =
            world.add(discShape(radius), {.at = {0, 0}, .restitution = 1, .friction = 0});
        for (int i = 0; i < 60 * 10 && world.changes.empty(); ++i) {
            world.step();
        }
        world.step();
        double const sine = aside / (2 * radius);
        double const cosine = std::sqrt(1 - sine * sine);
        Vec2 const velocity = world.motions[struck].velocity;
        RC_ASSERT(std::abs(velocity.x - speed * cosine * cosine) < 1e-3 * speed);
        RC_ASSERT(std::abs(velocity.y + speed * cosine * sine) < 1e-3 * speed);
    }));
}

TEST(NativeImpacts, LetABallRiseByTheSquareOfTheRestitution) {
    for (double const e : {1.0, 0.8, 0.5}) {
        SmallWorld world;
        world.floor();
        SlotIndex const ball = world.add(discShape(radius), {.at = {0, 1 + radius}, .restitution = e});
        double highest = 0;
        // From the first impact to the second one.
        double const first = std::sqrt(2 / standardGravity);
        double const second = first + 2 * e * first;
        for (int i = 0; i < static_cast<int>(second * 60) - 1; ++i) {
            world.step();
            if (i > static_cast<int>(first * 60) + 1) {
                highest = std::max(highest, world.motions[ball].centre.y - radius);
            }
        }
        EXPECT_NEAR(highest, e * e, 2e-3) << e; // between two frames it may be a little higher
    }
}

TEST(NativeImpacts, NeitherTakeNorGiveAPerfectlyElasticBallEnergy) {
    SmallWorld world;
    world.floor();
    SlotIndex const ball = world.add(discShape(radius), {.at = {0, 1 + radius}, .restitution = 1});
    double const before = world.energy();
    for (int i = 0; i < 1800; ++i) {
        world.step();
        ASSERT_NEAR(world.energy(), before, 2e-3 * before) << i;
    }
    EXPECT_GT(world.motions[ball].centre.y, 0.99 * radius);
}

TEST(NativeImpacts, EndAtTheTimeOfTheGeometricSeries) {
    double const e = 0.9;
    SmallWorld world;
    world.floor();
    SlotIndex const ball = world.add(discShape(radius), {.at = {0, 1 + radius}, .restitution = e});
    double const rests = std::sqrt(2 / standardGravity) * (1 + e) / (1 - e);
    world.step(static_cast<int>(60 * (rests + 0.5)));
    EXPECT_NEAR(world.motions[ball].centre.y, radius, 1e-3);
    EXPECT_LT(length(world.motions[ball].velocity), 0.02);
}

TEST(NativeImpacts, PassThroughTouchingBallsAsInNewtonsCradle) {
    for (int const thrown : {1, 2, 3}) {
        SmallWorld world(0);
        constexpr int balls = 5;
        std::vector<SlotIndex> all;
        for (int i = 0; i < thrown; ++i) {
            all.push_back(world.add(
                discShape(radius),
                {.at = {-2 + 2 * radius * i, 0}, .velocity = {2, 0}, .restitution = 1, .friction = 0}));
        }
        for (int i = 0; i < balls; ++i) {
            all.push_back(
                world.add(discShape(radius), {.at = {2 * radius * i, 0}, .restitution = 1, .friction = 0}));
        }
        world.step(120);
        for (int i = 0; i < thrown + balls; ++i) {
            EXPECT_NEAR(world.motions[all[static_cast<std::size_t>(i)]].velocity.x, i < balls ? 0 : 2, 1e-6)
                << thrown << " thrown, ball " << i;
        }
    }
}

TEST(NativeImpacts, AreReportedThoughTheBodiesHavePartedAtTheFramesEnd) {
    SmallWorld world(0);
    SlotIndex const a =
        world.add(discShape(radius), {.at = {-0.5, 0}, .velocity = {12, 0}, .restitution = 1});
    SlotIndex const b = world.add(discShape(radius), {.at = {0, 0}, .restitution = 1});
    world.step(4);
    ASSERT_EQ(world.changes.size(), 2U);
    EXPECT_EQ(world.changes[0].delta, 1);
    EXPECT_EQ(world.changes[1].delta, -1);
    EXPECT_NEAR(world.motions[a].velocity.x, 0, 1e-9);
    EXPECT_NEAR(world.motions[b].velocity.x, 12, 1e-9);
}

// However fast and however thin: what the plate gets is what the bullet had.
TEST(NativeImpacts, LetNothingPassThroughThinThings) {
    EXPECT_TRUE(rc::check([] {
        double const speed = std::pow(10, 1 + 3 * unit());
        double const thin = std::pow(10, -3 + 2 * unit());
        SmallWorld world(0);
        SlotIndex const plate = world.add(boxShape(thin, 1), {.at = {3, 0}, .mass = 10});
        SlotIndex const bullet =
            world.add(discShape(0.02), {.at = {0, 0}, .velocity = {speed, 0}, .mass = 0.01});
        world.step(30);
        RC_ASSERT(std::abs(world.motions[plate].velocity.x - 0.01 * speed / 10.01) < 1e-4 * speed);
        RC_ASSERT(world.motions[bullet].centre.x < world.motions[plate].centre.x);
    }));
}

} // namespace
} // namespace native_impact_test
} // namespace trembler::test
