// Kepler's third law in whole frames: the forces of Real Gravity, passed on by the interaction, integrated by
// Dynamics. T = 2 pi sqrt(a³ / (G (M + m))).
#include "physics/depth.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/register_physics.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace trembler {
namespace {

struct Orbit {
    double semiMajor = 5; ///< m
    double eccentricity = 0;
    double starMass = 1000; ///< kg
    double planetMass = 1;  ///< kg
    bool starFixed = true;
    bool starByDensity = false; ///< its mass is not stated, but follows from its size and its density
    double period = 10;         ///< s, by which the constant of gravity is chosen
    int substeps = 1;           ///< see the last test
};

struct Measured {
    double period = 0;        ///< s, mean over the revolutions
    double leastDistance = 0; ///< m
    double greatestDistance = 0;
    Vec2 drift; ///< m/s, of the centre of mass
};

Measured measure(Orbit const& orbit, int revolutions) {
    Registry registry;
    registerEverything(registry);
    World world(registry);
    Store& store = world.store();
    auto const body = [&](char const* name, double mass, double radius, Vec2 at, Vec2 velocity) {
        ObjectId const id = store.create(name);
        store.column<Shape>().set(id, {{circlePiece(radius)}});
        store.column<Mass>().set(id, {mass});
        store.column<Position>().set(id, {at});
        store.column<Velocity>().set(id, {velocity});
        return id;
    };
    // With the star fixed the planet falls towards it alone; else both move about their centre of mass.
    double const moving = orbit.starFixed ? orbit.starMass : orbit.starMass + orbit.planetMass;
    double const constant =
        4 * pi * pi * std::pow(orbit.semiMajor, 3) / (orbit.period * orbit.period * moving);
    store.column<GravityLaw>().set(store.create("world"), {constant, 1e-3});
    // Starts at the periapsis, on the x axis, moving in y (vis-viva).
    double const r = orbit.semiMajor * (1 - orbit.eccentricity);
    double const speed = std::sqrt(constant * moving * (2 / r - 1 / orbit.semiMajor));
    double const share = orbit.starFixed ? 0 : orbit.planetMass / moving;
    ObjectId const star = body("star", orbit.starMass, 0.2, {-share * r, 0}, {0, -share * speed});
    ObjectId const planet =
        body("planet", orbit.planetMass, 0.1, {(1 - share) * r, 0}, {0, (1 - share) * speed});
    if (orbit.starFixed) {
        store.column<Fixed>().set(star, {});
    }
    if (orbit.starByDensity) {
        store.column<Mass>().remove(star);
        store.column<Density>().set(star, {orbit.starMass / (pi * 0.2 * 0.2 * worldDepth)});
    }
    DynamicsSettings settings;
    settings.substeps = orbit.substeps;
    store.column<DynamicsSettings>().set(store.find("world"), settings);
    world.start();
    Measured measured;
    measured.leastDistance = measured.greatestDistance = r;
    double before = 0;
    std::optional<double> first;
    int crossings = 0;
    int const most = static_cast<int>(60 * orbit.period * (revolutions + 1.5));
    for (int frame = 1; frame <= most && crossings <= revolutions; ++frame) {
        world.step();
        Vec2 const apart = world.find<Position>(planet)->value - world.find<Position>(star)->value;
        measured.leastDistance = std::min(measured.leastDistance, length(apart));
        measured.greatestDistance = std::max(measured.greatestDistance, length(apart));
        // Upwards through the x axis, in between two frames.
        if (before < 0 && apart.y >= 0 && apart.x > 0) {
            double const when = (frame - apart.y / (apart.y - before)) * frameDuration;
            if (!first) {
                first = when;
            } else {
                measured.period = (when - *first) / crossings;
            }
            ++crossings;
        }
        before = apart.y;
    }
    EXPECT_EQ(crossings, revolutions + 1) << "the planet went astray";
    double const total = orbit.starMass + orbit.planetMass;
    measured.drift = (orbit.planetMass / total) * world.find<Velocity>(planet)->value +
                     (orbit.starMass / total) * world.find<Velocity>(star)->value;
    return measured;
}

TEST(KeplerPeriod, OfACircularOrbitAroundAFixedStar) {
    Measured const m = measure({}, 5);
    EXPECT_NEAR(m.period, 10, 0.01);
    EXPECT_NEAR(m.leastDistance, 5, 0.05);
    EXPECT_NEAR(m.greatestDistance, 5, 0.05);
}

// What is fixed has its mass for whoever asks, so a fixed sun attracts though nobody states a mass.
TEST(KeplerPeriod, OfAnOrbitAroundAFixedStarOfSomeDensity) {
    Measured const m = measure({.eccentricity = 0.2, .starByDensity = true}, 5);
    EXPECT_NEAR(m.period, 10, 0.01);
    EXPECT_NEAR(m.leastDistance, 4, 0.05);
    EXPECT_NEAR(m.greatestDistance, 6, 0.05);
}

TEST(KeplerPeriod, OfAnEccentricOrbitAroundAFixedStar) {
    Measured const m = measure({.semiMajor = 5, .eccentricity = 0.5}, 5);
    EXPECT_NEAR(m.period, 10, 0.02);
    EXPECT_NEAR(m.leastDistance, 2.5, 0.05);
    EXPECT_NEAR(m.greatestDistance, 7.5, 0.05);
}

TEST(KeplerPeriod, GrowsWithTheSemiMajorAxisAsTheThirdLawSays) {
    // The same star: the period asked for is that of 5 m, and the axis is doubled.
    Orbit wide{.semiMajor = 10};
    wide.period = 10 * std::pow(2, 1.5);
    Measured const m = measure(wide, 3);
    EXPECT_NEAR(m.period, 10 * std::pow(2, 1.5), 0.03);
}

TEST(KeplerPeriod, OfTwoBodiesThatBothMove) {
    Measured const m = measure(
        {.semiMajor = 5, .eccentricity = 0.3, .starMass = 1000, .planetMass = 300, .starFixed = false}, 5);
    EXPECT_NEAR(m.period, 10, 0.02);
    EXPECT_LT(length(m.drift), 1e-3) << "momentum is conserved";
}

TEST(KeplerPeriod, OfAHeavyFreeStarIsNearlyThatOfAFixedOne) {
    Measured const m = measure({.starMass = 1e6, .planetMass = 1, .starFixed = false}, 3);
    EXPECT_NEAR(m.period, 10, 0.01);
}

// A frame's forces stand for all its substeps, so with n of them they lag behind the motion by (1 - 1/n) / 2
// of a frame on the mean. A lag t of a central force pulls forwards along the path: the radius grows as exp(2
// t w² time). One substep has no lag, which is why the tests above take one; more must not be worse than that
// explains.
TEST(KeplerPeriod, WithSubstepsOrbitsWidenNoFasterThanTheFramesForcesLag) {
    for (int const substeps : {2, 4, 16}) {
        Orbit orbit;
        orbit.period = 20;
        orbit.substeps = substeps;
        Measured const m = measure(orbit, 1);
        double const lag = (1 - 1.0 / substeps) / 2 * frameDuration;
        double const w = 2 * pi / orbit.period;
        double const most = 2 * lag * w * w * 2.05 * orbit.period; // until the second time round
        EXPECT_LT(std::log(m.greatestDistance / 5), 1.1 * most) << substeps;
    }
}

} // namespace
} // namespace trembler
