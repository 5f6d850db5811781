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
    bool starByDensity = false; ///< the star's mass follows from its size and density
    double period = 10;         ///< s, from which the constant of gravity follows
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
        // A crossing of the x axis upwards, interpolated between two frames.
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
    EXPECT_EQ(crossings, revolutions + 1) << "the planet left its orbit";
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

// A fixed body has a mass that others can read, so a fixed sun attracts even without a stated mass.
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

TEST(KeplerPeriod, GrowsWithTheSemiMajorAxisByTheThirdLaw) {
    // The same star: the constant is chosen for 5 m, and the axis is doubled.
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

// A frame's forces are held for all its substeps, so with n substeps they lag behind the motion by (1 - 1/n)
// / 2 of a frame on average. A lag t of a central force pulls forwards along the path: the radius grows as
// exp(2 t w² time). One substep has no lag, so the tests above use one; with more, the growth must not exceed
// this.
TEST(KeplerPeriod, WithSubstepsOrbitsWidenNoFasterThanTheFramesForcesLag) {
    for (int const substeps : {2, 4, 16}) {
        Orbit orbit;
        orbit.period = 20;
        orbit.substeps = substeps;
        Measured const m = measure(orbit, 1);
        double const lag = (1 - 1.0 / substeps) / 2 * frameDuration;
        double const w = 2 * pi / orbit.period;
        double const most = 2 * lag * w * w * 2.05 * orbit.period; // until the second revolution
        EXPECT_LT(std::log(m.greatestDistance / 5), 1.1 * most) << substeps;
    }
}

} // namespace
} // namespace trembler
