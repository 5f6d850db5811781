// Magnets and irons as points, their forces by formulas, and the rates of these forces.
#include "physics/inverse_square/kernels.hpp"
#include "physics/magnetism/magnetic_points.hpp"
#include "tests/physics/magnetism/magnetic_things.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>

namespace trembler {
namespace magnetic_points_test {
namespace {

using Sums = MagneticSum;

struct Things : test::MagneticThings {
    ObjectId thing(Vec2 at, double angle, double strength, double susceptibility,
                   MagneticPoles const& poles) {
        ObjectId const id = MagneticThings::thing(at, strength, susceptibility, poles);
        rotations.set(id, {angle});
        return id;
    }
    /// The sum over every pair, as in the pairwise level.
    MagneticForce forces(double lag = 0) {
        points.gather(columns(), lag);
        for (Sums const sum : {Sums::polesOnPoles, Sums::softOnPoles, Sums::polesOnSoft}) {
            auto const& receivers = points.receivers(sum);
            MagneticTotals const totals = points.totals(sum);
            inverse_square::addAllPairs(points.sources(sum), receivers, 0, receivers.size(),
                                        magneticSoftening * magneticSoftening, totals.forces,
                                        totals.stiffness);
        }
        MagneticForce found;
        points.exportForces(found);
        return found;
    }

    MagneticPoints points;
};

MagneticPoles bar(double half) {
    return {PoleSet::both, {half, 0}, {-half, 0}};
}

double anyBetween(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}

// The force between two poles far apart is Coulomb's, and close by it is the slope of its potential.
TEST(PoleForce, IsTheSlopeOfASoftenedPotential) {
    EXPECT_TRUE(rc::check("the derivative of q1 q2 / sqrt(r² + s²)", [] {
        Vec2 const r{anyBetween(-2, 2), anyBetween(-2, 2)};
        double const q1 = anyBetween(-1e3, 1e3);
        double const q2 = anyBetween(-1e3, 1e3);
        auto const energy = [&](Vec2 at) {
            return 1e-7 * q1 * q2 / std::sqrt(lengthSquared(at) + 0.05 * 0.05);
        };
        constexpr double step = 1e-6;
        // Moving the pole towards the other shortens r.
        Vec2 const slope{(energy(r + Vec2{step, 0}) - energy(r - Vec2{step, 0})) / (2 * step),
                         (energy(r + Vec2{0, step}) - energy(r - Vec2{0, step})) / (2 * step)};
        RC_ASSERT(length(poleForce(r, q1, q2) - slope) < 1e-4);
    }));
    EXPECT_NEAR(poleForce({3, 0}, 1e4, 1e4).x, -1e-7 * 1e8 / 9, 1e-3) << "like poles repel";
    EXPECT_EQ(poleForce({}, 1e4, 1e4), (Vec2{}));
}

TEST(MagneticPoints, ActionIsReactionAndNothingActsOnItself) {
    EXPECT_TRUE(rc::check("no force and no torque on all of them together", [] {
        Things things;
        for (int i = *rc::gen::inRange(1, 8); i > 0; --i) {
            bool const iron = *rc::gen::inRange(0, 3) == 0;
            things.thing({anyBetween(-3, 3), anyBetween(-3, 3)}, anyBetween(-3, 3),
                         iron ? 0 : anyBetween(10, 1e4), anyBetween(0, 500),
                         iron ? MagneticPoles{} : bar(anyBetween(0.05, 1)));
        }
        Vec2 sum;
        double torque = 0;
        double scale = 0;
        ObjectId before{0, 0};
        for (MagneticForce::Entry const& entry : things.forces().forces) {
            RC_ASSERT(!(entry.object < before)); // ascending
            before = entry.object;
            sum += entry.force;
            torque += cross(entry.point, entry.force);
            scale += length(entry.force);
        }
        RC_ASSERT(length(sum) <= 1e-12 * scale);
        RC_ASSERT(std::abs(torque) <= 1e-11 * scale);
    }));
    Things alone;
    alone.thing({}, 0.3, 1e6, 1e6, bar(0.2));
    for (MagneticForce::Entry const& entry : alone.forces().forces) {
        EXPECT_EQ(entry.force, (Vec2{}));
    }
}

TEST(MagneticPoints, PolesMoveWithTheirObjectsAndIronIsAtItsCentreOfMass) {
    Things things;
    double const quarter = std::acos(-1.0) / 2;
    ObjectId const magnet = things.thing({1, 2}, quarter, 100, 0, {PoleSet::both, {0.5, 0}, {-0.25, 0}});
    ObjectId const north = things.thing({9, 0}, 0, 100, 0, {PoleSet::north, {0.5, 0}, {}});
    ObjectId const iron = things.thing({5, 5}, quarter, 0, 50, {});
    things.shapes.set(iron, Shape{{circlePiece(0.1), circlePiece(0.1, {1, 0})}});
    auto const forces = things.forces().forces;
    ASSERT_EQ(forces.size(), 4U);
    EXPECT_EQ(forces[0].object, magnet);
    EXPECT_NEAR(length(forces[0].point - Vec2{1, 2.5}), 0, 1e-12) << "north before south";
    EXPECT_NEAR(length(forces[1].point - Vec2{1, 1.75}), 0, 1e-12);
    EXPECT_EQ(forces[2].object, north);
    EXPECT_EQ(forces[3].object, iron);
    EXPECT_NEAR(length(forces[3].point - Vec2{5, 5.5}), 0, 1e-12);
    // A magnet that is off, partly on, or has no strength.
    things.magnets.set(magnet, Magnet{false, 0});
    EXPECT_EQ(things.forces().forces.size(), 2U);
    Vec2 const full = things.forces().forces[1].force;
    things.magnets.set(north, Magnet{false, 0.5});
    EXPECT_NEAR(length(things.forces().forces[1].force - 0.5 * full), 0, 1e-12 * length(full));
    things.strengths.set(north, {0, 0});
    EXPECT_TRUE(things.forces().forces.empty()) << "iron alone attracts nothing";
    EXPECT_FALSE(things.points.active());
}

// Points are taken at the future places of their objects, but the forces act at the present ones; the shift
// is at most half a softening length.
TEST(MagneticPoints, LookAheadByTheirLag) {
    Things things;
    ObjectId const moving = things.thing({}, 0, 1000, 0, {PoleSet::north, {}, {}});
    static_cast<void>(things.thing({1, 0}, 0, 1000, 0, {PoleSet::south, {}, {}}));
    things.velocities.set(moving, {{2, 0}});
    double const lag = 0.01;
    auto const ahead = things.forces(lag).forces;
    EXPECT_NEAR(ahead[0].point.x, 0, 1e-12);
    EXPECT_NEAR(ahead[0].force.x, poleForce({1 - 0.02, 0}, 1000, -1000).x, 1e-12);
    things.velocities.set(moving, {{2000, 0}});
    EXPECT_NEAR(things.forces(lag).forces[0].force.x, poleForce({1 - 0.025, 0}, 1000, -1000).x, 1e-12);
    // A rotating body turns about its centre of mass.
    Things bars;
    ObjectId const needle = bars.thing({}, 0, 1000, 0, bar(0.5));
    bars.spins.set(needle, {10});
    bars.points.gather(bars.columns(), lag);
    auto const& poles = bars.points.sources(Sums::polesOnPoles);
    ASSERT_EQ(poles.size(), 2U);
    EXPECT_NEAR(length(poles.at(0) - rotated({0.5, 0}, 0.1)), 0, 1e-12);
}

// A free north pole in the field of a fixed south pole at its side: k = q q' µ/4π / r³ across the line.
TEST(MagneticPoints, RatesAreThoseOfTheOscillation) {
    Things things;
    ObjectId const bob = things.thing({}, 0, 1000, 0, {PoleSet::north, {}, {}});
    static_cast<void>(things.thing({1, 0}, 0, 2000, 0, {PoleSet::south, {}, {}}));
    EXPECT_TRUE(things.forces().rates.empty()) << "without masses there are no rates";
    things.masses.set(bob, {0.1});
    auto const rates = things.forces().rates;
    ASSERT_EQ(rates.size(), 1U);
    EXPECT_EQ(rates[0].object, bob);
    double const stiffness = 1e-7 * 1000 * 2000 / std::pow(1 + 0.05 * 0.05, 1.5);
    EXPECT_NEAR(rates[0].rate, std::sqrt(stiffness / 0.1), 1e-9);
    // Off the centre of mass the force also turns it: 1/m + a²/I, I = m r²/2 of a disc.
    things.shapes.set(bob, Shape{{circlePiece(0.2)}});
    things.poleSets.set(bob, {PoleSet::north, {0, 0.3}, {}});
    things.positions.set(bob, {{0, -0.3}});
    double const yield = 1 / 0.1 + 0.3 * 0.3 / (0.1 * 0.2 * 0.2 / 2);
    EXPECT_NEAR(things.forces().rates.at(0).rate, std::sqrt(stiffness * yield), 1e-9);
}

} // namespace
} // namespace magnetic_points_test
} // namespace trembler
