// Air as a fluid: objects in it compared with Archimedes' principle and with the law of drag.
#include "physics/buoyancy/properties/air.hpp"
#include "tests/physics/buoyancy/pool.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace trembler::test {
namespace {

constexpr double rounding = 2e-5; // m/s: Box2D computes in single precision
constexpr double earth = 9.81;
constexpr double moon = 1.62;
constexpr double radius = 0.25;
constexpr double balloonVolume = std::numbers::pi * radius * radius * worldDepth; // m³
constexpr double balloonDensity = 0.4;                                            // kg/m³

void stateAir(Pool& pool, Air air) {
    pool.give(pool.world->store().find("world"), air);
}

ObjectId balloonIn(Pool& pool, Vec2 at = {0, 0}) {
    return pool.body("balloon", circlePiece(radius), at, balloonDensity);
}

TEST(Air, AcceleratesALightBodyAsArchimedesSays) {
    for (double const gravity : {earth, moon}) {
        Pool pool({.gravity = {0, -gravity}});
        stateAir(pool, {.density = 1.2, .linearDrag = 0, .quadraticDrag = 0});
        ObjectId const balloon = balloonIn(pool);
        pool.run(31); // forces act from the second frame on
        EXPECT_NEAR(pool.velocity(balloon).y, gravity * (1.2 / balloonDensity - 1) * 0.5, rounding);
        EXPECT_NEAR(pool.velocity(balloon).x, 0, 1e-12);
    }
}

TEST(Air, RisesAgainstGravityWhicheverWayItPoints) {
    Pool pool({.gravity = {3, 4}});
    ObjectId const balloon = balloonIn(pool);
    pool.run(1);
    Vec2 const force = pool.force(balloon);
    EXPECT_NEAR(force.x, -3 * 1.2 * balloonVolume, 1e-12);
    EXPECT_NEAR(force.y, -4 * 1.2 * balloonVolume, 1e-12);
}

TEST(Air, LiftsWithoutGravityAndWithoutAirNothing) {
    Pool floating({.gravity = {0, 0}});
    ObjectId const one = balloonIn(floating);
    floating.run(60);
    EXPECT_EQ(floating.at(one), Vec2{});
    Pool empty;
    stateAir(empty, {.density = 0});
    ObjectId const other = balloonIn(empty);
    empty.run(31);
    EXPECT_NEAR(empty.velocity(other).y, -earth / 2, rounding);
}

TEST(Air, DragEndsTheAcceleration) {
    Pool pool;
    ObjectId const balloon = balloonIn(pool);
    pool.seconds(20);
    // c1 m v + c2 ½ ρ w d v² = (ρ - balloonDensity) g V, w the side of the rectangle with the disc's second
    // moment.
    double const linear = 0.5 * 1.2 * balloonVolume;
    double const quadratic = 1.2 / 2 * std::sqrt(3) * radius * worldDepth;
    double const lift = (1.2 - balloonDensity) * earth * balloonVolume;
    double const speed = (std::sqrt(linear * linear + 4 * quadratic * lift) - linear) / (2 * quadratic);
    EXPECT_NEAR(pool.velocity(balloon).y, speed, rounding);
    EXPECT_LT(speed, 5);
}

TEST(Air, ABalloonHoversWithTheWeightThatItCarries) {
    double const carried = (1.2 - balloonDensity) * balloonVolume; // kg
    struct Case {
        double share; // of `carried`
        double least; // m that the weight moves in 5 s
        double most;
    };
    for (Case const c : {Case{1, -0.001, 0.001}, Case{0.8, 0.5, 20}, Case{1.2, -20, -0.5}}) {
        Pool pool;
        ObjectId const balloon = balloonIn(pool, {0, 1});
        ObjectId const weight = pool.body("weight", boxPiece(0.02, 0.02), {0, 0}, 1000);
        pool.give(weight, Mass{c.share * carried});
        pool.joint("string",
                   {.form = JointForm::rope, .a = balloon, .b = weight, .at = {0, 0.75}, .atB = {0, 0.01}});
        pool.seconds(5);
        EXPECT_GT(pool.at(weight).y, c.least) << c.share;
        EXPECT_LT(pool.at(weight).y, c.most) << c.share;
        EXPECT_NEAR(length(pool.at(balloon) - pool.at(weight)), 1, 0.02) << c.share;
    }
}

TEST(Air, ActsOnHeavyBodiesOnlyIfTheWorldStatesIt) {
    auto const fall = [](bool balloon, bool stated) {
        Pool pool;
        if (stated) {
            stateAir(pool, {.density = 65, .linearDrag = 0, .quadraticDrag = 0}); // the air of Venus
        }
        ObjectId const stone = pool.body("stone", boxPiece(0.3, 0.2), {0, 0}, 2600, 0.3);
        if (balloon) {
            balloonIn(pool, {5, 0});
        }
        pool.run(31);
        return pool.velocity(stone).y;
    };
    EXPECT_EQ(fall(true, false), fall(false, false));
    EXPECT_NEAR(fall(false, false), -earth / 2, rounding);
    EXPECT_NEAR(fall(false, true), -earth / 2 * (1 - 65.0 / 2600), rounding);
}

TEST(Air, ActsOnTheDryPartOfAFloatingBody) {
    struct Level {
        char const* name;
        double error; // of the immersed share of the box
    };
    for (Level const level : {Level{"exact", 1e-6}, Level{"particles", 0.03}}) {
        Pool pool({.detail = level.name});
        stateAir(pool, {.density = 65});
        pool.water();
        ObjectId const box = pool.body("box", boxPiece(0.4, 0.2), {0, 0.05}, 300); // a quarter is immersed
        ObjectId const sunk = pool.body("sunk", boxPiece(0.4, 0.2), {3, -3}, 300);
        pool.run(1);
        double const volume = 0.4 * 0.2 * worldDepth;
        double const water = earth * volume * 1000; // N
        EXPECT_NEAR(pool.force(box).y, 0.25 * water + 0.75 * earth * volume * 65, level.error * water)
            << level.name;
        EXPECT_NEAR(pool.force(sunk).y, water, 1e-6 * water) << level.name;
    }
}

TEST(Air, WindCarriesABalloonAtItsOwnSpeed) {
    Pool pool({.gravity = {0, 0}});
    stateAir(pool, {.wind = {2, -1}});
    ObjectId const balloon = balloonIn(pool);
    pool.seconds(60);
    EXPECT_NEAR(pool.velocity(balloon).x, 2, 1e-3);
    EXPECT_NEAR(pool.velocity(balloon).y, -1, 1e-3);
}

TEST(Air, ABalloonUnderACeilingComesToRestAndSleeps) {
    Pool pool;
    pool.fixed("ceiling", boxPiece(4, 0.2), {0, 2});
    ObjectId const balloon = balloonIn(pool, {0.3, 0});
    pool.seconds(60);
    EXPECT_NEAR(pool.at(balloon).y, 1.9 - radius, 0.01);
    EXPECT_EQ(pool.activity("Buoyancy"), Activity::asleep);
    EXPECT_EQ(pool.activity("Dynamics <- Buoyancy"), Activity::asleep);
}

} // namespace
} // namespace trembler::test
