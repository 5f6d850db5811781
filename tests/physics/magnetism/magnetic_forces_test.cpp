// Forces between magnets compared with independently computed formulas: Coulomb's law for poles, the far
// field of a dipole, Newton's third law.
#include "tests/physics/magnetism/magnet_world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

namespace trembler {
namespace {

using namespace test;

// A pole in the world, for the reference: in long double, by components, softening as the distance to a point
// one softening length above the plane.
struct Point {
    long double x;
    long double y;
    long double q;
};
std::pair<long double, long double> coulomb(Point const& on, Point const& from) {
    long double const dx = on.x - from.x;
    long double const dy = on.y - from.y;
    long double const d = std::sqrt(dx * dx + dy * dy + 0.05L * 0.05L);
    long double const strength = 1e-7L * on.q * from.q / (d * d); // along the line to the raised point
    return {strength * dx / d, strength * dy / d};                // like poles repel
}
std::vector<Point> polesOf(Vec2 at, double angle, double q, MagneticPoles const& poles) {
    std::vector<Point> all;
    auto const add = [&](Vec2 local, double sign) {
        all.push_back({at.x + std::cos(angle) * local.x - std::sin(angle) * local.y,
                       at.y + std::sin(angle) * local.x + std::cos(angle) * local.y, sign * q});
    };
    if (poles.poles == PoleSet::north || poles.poles == PoleSet::both) {
        add(poles.north, 1);
    }
    if (poles.poles == PoleSet::south || poles.poles == PoleSet::both) {
        add(poles.south, -1);
    }
    return all;
}
void expectNear(Vec2 measured, long double x, long double y, double relative) {
    double const scale = static_cast<double>(std::hypot(x, y));
    EXPECT_NEAR(measured.x, static_cast<double>(x), relative * scale);
    EXPECT_NEAR(measured.y, static_cast<double>(y), relative * scale);
}

TEST(MagneticForces, OfTwoBarMagnetsIsTheSumOverTheirPoles) {
    MagneticPoles const poles = barPoles(0.4);
    MagnetWorld magnets;
    ObjectId const a = magnets.magnet({0, 0}, 0.3, 500, poles);
    ObjectId const b = magnets.magnet({0.7, 0.2}, 2.1, 800, poles);
    magnets.run(1);
    long double x = 0;
    long double y = 0;
    for (Point const& on : polesOf({0, 0}, 0.3, 500, poles)) {
        for (Point const& from : polesOf({0.7, 0.2}, 2.1, 800, poles)) {
            auto const [fx, fy] = coulomb(on, from);
            x += fx;
            y += fy;
        }
    }
    EXPECT_GT(std::hypot(x, y), 1e-3L) << "the force must be large enough to test";
    expectNear(magnets.force(a), x, y, 1e-12);
    expectNear(magnets.force(b), -x, -y, 1e-12);
}

TEST(MagneticForces, OfMonopolesRepelsLikeAndAttractsUnlike) {
    for (PoleSet const other : {PoleSet::north, PoleSet::south}) {
        MagnetWorld magnets;
        ObjectId const a = magnets.magnet({0, 0}, 0, 1000, {PoleSet::north, {}, {}});
        ObjectId const b = magnets.magnet({2, 0}, 0, 3000, {other, {}, {}});
        magnets.run(1);
        double const expected =
            1e-7 * 1000 * 3000 * 2 / std::pow(4 + 0.0025, 1.5) * (other == PoleSet::north ? -1 : 1);
        EXPECT_NEAR(magnets.force(a).x, expected, 1e-15);
        EXPECT_NEAR(magnets.force(b).x, -expected, 1e-15);
        EXPECT_EQ(magnets.force(a).y, 0);
        EXPECT_EQ(magnets.forces().size(), 2U) << "one pole, one force each";
    }
}

// Two magnets in line, far apart: F = 3 mu0 m1 m2 / (2 pi r^4), attractive, with m = q d (Griffiths,
// problem 6.1).
TEST(MagneticForces, FarApartAreThoseOfDipoles) {
    double const length = 0.2;
    double const q = 1e4;
    double const r = 5;
    MagnetWorld magnets;
    ObjectId const a = magnets.magnet({0, 0}, 0, q, barPoles(length));
    ObjectId const b = magnets.magnet({r, 0}, 0, q, barPoles(length));
    magnets.run(1);
    double const mu0 = 4e-7 * pi;
    double const moment = q * length;
    double const dipoles = 3 * mu0 * moment * moment / (2 * pi * std::pow(r, 4));
    EXPECT_NEAR(magnets.force(a).x, dipoles, 0.01 * dipoles);
    EXPECT_NEAR(magnets.force(b).x, -dipoles, 0.01 * dipoles);
    EXPECT_NEAR(magnets.force(a).y, 0, 1e-12 * dipoles);
}

TEST(MagneticForces, AttractSoftIronToEitherPole) {
    for (PoleSet const pole : {PoleSet::north, PoleSet::south}) {
        MagnetWorld magnets;
        ObjectId const magnet = magnets.magnet({0, 0}, 0, 1000, {pole, {}, {}});
        ObjectId const iron = magnets.soft({0, 1.5}, 200);
        magnets.run(1);
        double const pull = 1e-7 * 1000 * 200 * 1.5 / std::pow(1.5 * 1.5 + 0.0025, 1.5);
        EXPECT_NEAR(magnets.force(iron).y, -pull, 1e-15);
        EXPECT_NEAR(magnets.force(magnet).y, pull, 1e-15);
    }
    // Both poles of a bar attract iron, whatever their sign.
    MagnetWorld magnets;
    magnets.magnet({0, 0}, 0, 1000, barPoles(0.4));
    ObjectId const iron = magnets.soft({1, 0}, 200);
    magnets.run(1);
    double const near = 1e-7 * 1000 * 200 * 0.8 / std::pow(0.64 + 0.0025, 1.5);
    double const far = 1e-7 * 1000 * 200 * 1.2 / std::pow(1.44 + 0.0025, 1.5);
    EXPECT_NEAR(magnets.force(iron).x, -(near + far), 1e-15);
}

TEST(MagneticForces, AreZeroBetweenSoftIronsAndForASingleMagnet) {
    MagnetWorld irons;
    irons.soft({0, 0}, 100);
    irons.soft({0.3, 0}, 100);
    irons.magnet({0.1, 0}, 0, 0, barPoles(0.1)); // poles without strength
    irons.run(1);
    EXPECT_TRUE(irons.forces().empty());
    MagnetWorld alone;
    ObjectId const magnet =
        alone.magnet({0, 0}, 0, 1000, barPoles(0.4), 500); // a magnet that is also soft iron
    alone.run(1);
    EXPECT_EQ(alone.force(magnet), (Vec2{0, 0}));
}

TEST(MagneticForces, ActAtThePolesAndElseAtTheCentre) {
    MagnetWorld magnets;
    ObjectId const bar = magnets.magnet({1, 2}, pi / 2, 1000, barPoles(0.4));
    ObjectId const iron = magnets.soft({5, 5}, 10);
    magnets.run(1);
    auto const& forces = magnets.forces();
    ASSERT_EQ(forces.size(), 3U);
    EXPECT_EQ(forces[0].object, bar);
    EXPECT_NEAR(forces[0].point.x, 1, 1e-15);
    EXPECT_NEAR(forces[0].point.y, 2.2, 1e-15); // its north pole, turned by a quarter
    EXPECT_NEAR(forces[1].point.y, 1.8, 1e-15);
    EXPECT_EQ(forces[2].object, iron);
    EXPECT_EQ(forces[2].point, (Vec2{5, 5}));
}

// Newton's third law: the total force and torque of any set of magnets and irons are zero.
TEST(MagneticForces, ActionEqualsReaction) {
    EXPECT_TRUE(rc::check([] {
        auto const number = [](double low, double high) {
            return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
        };
        MagnetWorld magnets;
        auto const count = *rc::gen::inRange(2, 7);
        for (int i = 0; i < count; ++i) {
            Vec2 const at{number(-2, 2), number(-2, 2)};
            auto const poles = static_cast<PoleSet>(*rc::gen::inRange(1, 4));
            switch (*rc::gen::inRange(0, 3)) {
            case 0:
                magnets.soft(at, number(0, 1000));
                break;
            case 1:
                magnets.magnet(at, number(-3, 3), number(0, 1e4), {poles, {0.2, 0.1}, {-0.3, 0}});
                break;
            default: // also attracted like iron
                magnets.magnet(at, number(-3, 3), number(0, 1e4), {poles, {0.2, 0}, {-0.2, 0}},
                               number(0, 1000));
                break;
            }
        }
        magnets.run(1);
        Vec2 const pivot{number(-10, 10), number(-10, 10)};
        Vec2 force;
        double torque = 0;
        double scale = 0;
        for (MagneticForce::Entry const& entry : magnets.world.find<MagneticForce>() == nullptr
                                                     ? std::vector<MagneticForce::Entry>{}
                                                     : magnets.forces()) {
            force += entry.force;
            torque += cross(entry.point - pivot, entry.force);
            scale += length(entry.force);
        }
        RC_ASSERT(length(force) <= 1e-13 * scale);
        RC_ASSERT(std::abs(torque) <= 1e-11 * scale);
    }));
}

TEST(MagneticForces, AreFiniteAtZeroDistance) {
    EXPECT_EQ(poleForce({0, 0}, 1e8, 1e8), (Vec2{0, 0}));
    MagnetWorld magnets;
    ObjectId const a = magnets.magnet({0, 0}, 0, 1e8, {PoleSet::north, {}, {}});
    magnets.magnet({0, 0}, 0, 1e8, {PoleSet::south, {}, {}});
    magnets.soft({0, 0}, 1e8);
    magnets.magnet({1e-300, 0}, 0, 1e8, {PoleSet::south, {}, {}});
    magnets.run(1);
    for (MagneticForce::Entry const& entry : magnets.forces()) {
        EXPECT_TRUE(isFinite(entry.force));
    }
    EXPECT_LT(length(magnets.force(a)), 1e-200);
}

// "Finite (and zero) at distance zero and within 1 % of the inverse square from 0.61 m on."
TEST(MagneticForces, AreSoftenedAsDocumented) {
    auto const shareOfInverseSquare = [](double r) {
        return -poleForce({r, 0}, 1, 1).x / (magneticConstant / (r * r));
    };
    EXPECT_LT(shareOfInverseSquare(0.60), 0.99);
    for (double r = 0.61; r < 100; r *= 1.01) {
        EXPECT_GE(shareOfInverseSquare(r), 0.99) << r;
        EXPECT_LT(shareOfInverseSquare(r), 1 + 1e-15) << r;
    }
    // The force is greatest at s / sqrt(2), and falls on both sides.
    double const peak = magneticSoftening / std::sqrt(2.0);
    double const strongest = length(poleForce({peak, 0}, 1, 1));
    for (double r = 0; r < 1; r += 0.001) {
        EXPECT_LE(length(poleForce({r, 0}, 1, 1)), strongest * (1 + 1e-15));
    }
}

TEST(MagneticForces, DoNotDependOnTheOrderOfPlacing) {
    auto const forceOnMiddle = [](bool reversed) {
        MagnetWorld magnets;
        ObjectId middle;
        if (reversed) {
            magnets.soft({1, 1}, 100);
            middle = magnets.magnet({0, 0}, 0, 1000, barPoles(0.2));
            magnets.magnet({-1, 0}, 1, 1000, barPoles(0.2));
        } else {
            magnets.magnet({-1, 0}, 1, 1000, barPoles(0.2));
            middle = magnets.magnet({0, 0}, 0, 1000, barPoles(0.2));
            magnets.soft({1, 1}, 100);
        }
        magnets.run(1);
        return magnets.force(middle);
    };
    EXPECT_NEAR(length(forceOnMiddle(true) - forceOnMiddle(false)), 0, 1e-15);
}

// The sum for each pole is separate, in the order of objects: no bit may depend on threads.
TEST(MagneticForcesParallel, OfThreeThousandPolesAreTheSameBitsForAnyNumberOfThreads) {
    std::vector<MagneticForce::Entry> first;
    for (int const threads : {1, 2, 3, 8}) {
        MagnetWorld magnets(threads);
        magnets.world.setDetail("magnetism", "pairwise"); // else so many magnets would get the tree
        for (int i = 0; i < 1500; ++i) {
            Vec2 const at{0.37 * (i % 40), 0.41 * (i / 40)};
            magnets.magnet(at, 0.1 * i, 100 + i, barPoles(0.2));
            if (i % 10 == 0) {
                magnets.soft(at + Vec2{0.15, 0.2}, 50);
            }
        }
        magnets.run(1);
        ASSERT_EQ(magnets.forces().size(), 3150U);
        if (first.empty()) {
            first = magnets.forces();
        }
        for (std::size_t i = 0; i < first.size(); ++i) {
            ASSERT_EQ(first[i].object, magnets.forces()[i].object);
            ASSERT_EQ(first[i].force, magnets.forces()[i].force) << i << " on " << threads;
        }
    }
}

} // namespace
} // namespace trembler
