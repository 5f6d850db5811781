// The substeps that a scene needs, compared with the modes of a hanging chain, the beam that a weld holds,
// searches over graphs, and widths measured in all directions.
#include "physics/dynamics/core/demand/solver_demand.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "tests/physics/dynamics/core/demand/tied_bodies.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>

namespace trembler::test {
namespace solver_demand_test {
namespace {

constexpr double g = 9.81;

JointDemand demandOf(TiedBodies const& tied) {
    return jointDemand(tied.columns(), tied.bodies(), tied.joints(), tied.loads());
}

// A chain of rods that hangs from the world, pinned end to end, with a small weight at its end.
struct Chain {
    std::vector<double> lengths; // m
    std::vector<double> masses;  // kg
    double weight = 0;           // kg
    double gravity = g;

    [[nodiscard]] JointDemand demand(Vec2 down = {0, -1}) const {
        TiedBodies tied;
        ObjectId above;
        Vec2 at;
        for (std::size_t i = 0; i < lengths.size(); ++i) {
            ObjectId const rod = tied.body(Shape{{boxPiece(lengths[i], thin)}}, at + lengths[i] / 2 * down,
                                           masses[i], std::atan2(down.y, down.x));
            tied.joint(JointForm::hinge, rod, above, at);
            at += lengths[i] * down;
            above = rod;
        }
        tied.joint(JointForm::hinge, tied.body(Shape{{circlePiece(0.05)}}, at, weight), above, at);
        tied.weigh(gravity * down);
        tied.settle();
        return demandOf(tied);
    }
    // The fastest of its small oscillations (rad/s), from the joints' sideways shifts y: the energies are
    // ½ y'ᵀ M y' and ½ yᵀ K y, where each rod's tension is the weight below its middle.
    [[nodiscard]] double fastestMode() const {
        auto const n = static_cast<Eigen::Index>(lengths.size());
        Eigen::MatrixXd inertia = Eigen::MatrixXd::Zero(n, n);
        Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
        double below = weight;
        for (Eigen::Index i = n - 1; i >= 0; --i) {
            double const l = lengths[static_cast<std::size_t>(i)];
            double const m = masses[static_cast<std::size_t>(i)];
            double const turning = m * (l * l + thin * thin) / 12 / (l * l);
            double const tension = gravity * (below + m / 2) / l;
            below += m;
            auto const both = [i](Eigen::MatrixXd& matrix, double own, double other) {
                matrix(i, i) += own;
                if (i > 0) {
                    matrix(i - 1, i - 1) += own;
                    matrix(i, i - 1) += other;
                    matrix(i - 1, i) += other;
                }
            };
            both(inertia, m / 4 + turning, m / 4 - turning);
            both(stiffness, tension, -tension);
        }
        inertia(n - 1, n - 1) += weight;
        Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> const solver(stiffness, inertia,
                                                                               Eigen::EigenvaluesOnly);
        return std::sqrt(solver.eigenvalues().maxCoeff());
    }
    static constexpr double thin = 0.02; // m, the rods' width
};

TEST(JointDemand, IsTheFastestModeOfAChainThatAWeightPullsTaut) {
    Chain const chain{std::vector<double>(24, 0.3), std::vector<double>(24, 0.5), 5000};
    double const mode = chain.fastestMode();
    double const zigZag = chain.demand().zigZag;
    EXPECT_GE(zigZag, mode);
    EXPECT_LT(zigZag, 1.01 * mode);
    EXPECT_NEAR(chain.demand({0.6, 0.8}).zigZag, zigZag, 1e-9 * zigZag) << "in any direction of its weight";
    Chain elsewhere = chain;
    elsewhere.gravity = g / 4;
    EXPECT_NEAR(elsewhere.demand().zigZag, zigZag / 2, 1e-9 * zigZag);
}

TEST(JointDemand, IsNeverBelowTheFastestModeOfAnyChain) {
    EXPECT_TRUE(rc::check([] {
        Chain chain;
        int const links = *rc::gen::inRange(1, 12);
        for (int i = 0; i < links; ++i) {
            chain.lengths.push_back(0.05 * *rc::gen::inRange(1, 21));
            chain.masses.push_back(0.1 * *rc::gen::inRange(1, 101));
        }
        chain.weight = *rc::gen::inRange(1, 1000);
        double const mode = chain.fastestMode();
        double const zigZag = chain.demand().zigZag;
        RC_LOG() << "mode " << mode << " rad/s, demand " << zigZag << " rad/s\n";
        RC_ASSERT(zigZag >= mode * (1 - 1e-9));
        // The upper bound is the fastest rod under the greatest tension.
        double shortest = chain.lengths[0];
        double lightest = chain.masses[0];
        double all = chain.weight;
        for (std::size_t i = 0; i < chain.lengths.size(); ++i) {
            shortest = std::min(shortest, chain.lengths[i]);
            lightest = std::min(lightest, chain.masses[i]);
            all += chain.masses[i];
        }
        RC_ASSERT(zigZag <= std::sqrt(12 * all * g / (lightest * shortest)) * (1 + 1e-9));
    }));
}

TEST(JointDemand, OfAnUnloadedChainIsNone) {
    Chain chain{{0.3, 0.3, 0.3}, {1, 1, 1}, 100};
    chain.gravity = 0;
    JointDemand const demand = chain.demand();
    EXPECT_EQ(demand.zigZag, 0);
    EXPECT_EQ(demand.bending, 0);
    EXPECT_EQ(demand.network, 4U);
    JointDemand const nothing = demandOf(TiedBodies{});
    EXPECT_EQ(nothing.zigZag, 0);
    EXPECT_EQ(nothing.network, 0U);
}

// A welded body cannot turn about its other joints.
TEST(JointDemand, AWeldStiffensTheRodThatItHolds) {
    TiedBodies tied;
    ObjectId const rod = tied.body(Shape{{boxPiece(1, 0.02)}}, {0.5, 0}, 1);
    tied.joint(JointForm::weld, rod, {}, {0, 0});
    tied.joint(JointForm::hinge, tied.body(Shape{{circlePiece(0.05)}}, {1, 0}, 1000), rod, {1, 0});
    tied.weigh({0, -g});
    tied.settle();
    EXPECT_EQ(demandOf(tied).zigZag, 0);
    EXPECT_GT(demandOf(tied).bending, 0);
}

// A beam of n planks of the length l and the mass m each, welded to a wall: at the wall W = n m g acts at
// d = n l / 2, and a thin plank has I = m l² / 12. So ω² = 6 n² g / l, whatever the mass.
TEST(JointDemand, OfABeamGrowsWithItsLength) {
    for (int const planks : {1, 2, 5, 10}) {
        for (double const angle : {0.0, 0.7, 2.5}) {
            TiedBodies tied;
            Vec2 const along{std::cos(angle), std::sin(angle)};
            ObjectId before;
            constexpr double l = 0.5;
            constexpr double h = 0.02;
            for (int i = 0; i < planks; ++i) {
                ObjectId const plank =
                    tied.body(Shape{{boxPiece(l, h)}}, (i + 0.5) * l * along, 3, angle + pi * (i % 2));
                tied.joint(JointForm::weld, i % 2 == 0 ? plank : before, i % 2 == 0 ? before : plank,
                           i * l * along);
                before = plank;
            }
            tied.weigh({0, -g});
            tied.settle();
            double const thin = l * l / (l * l + h * h);
            EXPECT_NEAR(demandOf(tied).bending, std::sqrt(6 * planks * planks * g / l * thin), 1e-9)
                << planks << " planks at " << angle;
        }
    }
}

TEST(JointDemand, NetworkIsTheGreatestNumberOfRigidTiesInOnePiece) {
    EXPECT_TRUE(rc::check([] {
        TiedBodies tied;
        std::vector<ObjectId> bodies;
        std::vector<bool> fixed;
        int const count = *rc::gen::inRange(2, 12);
        for (int i = 0; i < count; ++i) {
            fixed.push_back(*rc::gen::inRange(0, 4) == 0);
            Vec2 const at{1.0 * i, 0};
            bodies.push_back(fixed.back() ? tied.fixed(at) : tied.body(at, 1));
        }
        std::vector<std::pair<std::size_t, std::size_t>> ties;
        int const joints = *rc::gen::inRange(0, 16);
        for (int i = 0; i < joints; ++i) {
            auto const a = static_cast<std::size_t>(*rc::gen::inRange(0, count));
            auto const b = static_cast<std::size_t>(*rc::gen::inRange(0, count));
            if (a == b || (fixed[a] && fixed[b])) {
                continue;
            }
            JointForm const form = *rc::gen::element(JointForm::hinge, JointForm::weld, JointForm::distance,
                                                     JointForm::rope, JointForm::slider, JointForm::spring);
            tied.joint(form, bodies[a], bodies[b], {0, 0});
            if (form == JointForm::hinge || form == JointForm::weld || form == JointForm::distance) {
                ties.emplace_back(a, b);
            }
        }
        tied.settle();
        // Each piece, found by a search from one of its bodies.
        std::size_t most = 0;
        for (std::size_t from = 0; from < bodies.size(); ++from) {
            std::set<std::size_t> piece{from};
            for (std::size_t round = 0; round < bodies.size() && !fixed[from]; ++round) {
                for (auto const& [a, b] : ties) {
                    if (!fixed[a] && !fixed[b] && (piece.contains(a) || piece.contains(b))) {
                        piece.insert({a, b});
                    }
                }
            }
            auto const count = std::count_if(ties.begin(), ties.end(), [&](auto const& tie) {
                return !fixed[from] && (piece.contains(tie.first) || piece.contains(tie.second));
            });
            most = std::max(most, static_cast<std::size_t>(count));
        }
        RC_ASSERT(demandOf(tied).network == most);
    }));
}

// The least distance between two parallel lines around the piece, over many sampled angles.
double widthOf(ShapePiece const& piece) {
    std::vector<Vec2> points = piece.corners;
    double around = 0;
    switch (piece.form) {
    case ShapeForm::circle:
        points = {{0, 0}};
        around = piece.radius;
        break;
    case ShapeForm::capsule:
        points = {{piece.width / 2 - piece.radius, 0}, {piece.radius - piece.width / 2, 0}};
        around = piece.radius;
        break;
    case ShapeForm::box:
        points = {{piece.width / 2, piece.height / 2},
                  {-piece.width / 2, piece.height / 2},
                  {-piece.width / 2, -piece.height / 2},
                  {piece.width / 2, -piece.height / 2}};
        break;
    case ShapeForm::polygon:
        break;
    }
    double least = 1e9;
    constexpr int angles = 1200;
    for (int i = 0; i < angles; ++i) {
        Vec2 const across{std::cos(pi * i / angles), std::sin(pi * i / angles)};
        double low = 1e9;
        double high = -1e9;
        for (Vec2 const point : points) {
            low = std::min(low, dot(point, across));
            high = std::max(high, dot(point, across));
        }
        least = std::min(least, high - low + 2 * around);
    }
    return least;
}

ShapePiece somePiece() {
    double const size = 0.02 * std::exp2(*rc::gen::inRange(0, 60) / 10.0);
    // The factor first: size * 10 / 10 may be a bit less than size, and then a capsule is shorter than its
    // ends.
    double const longer = size * (*rc::gen::inRange(10, 40) / 10.0);
    switch (*rc::gen::inRange(0, 4)) {
    case 0:
        return circlePiece(size / 2);
    case 1:
        return capsulePiece(longer, size / 2, {0.1, 0}, 0.3);
    case 2:
        return *rc::gen::arbitrary<bool>() ? boxPiece(longer, size) : boxPiece(size, longer, {0, 0.2}, 1);
    default:
        return polygonPiece({{-longer, -size}, {longer, -0.7 * size}, {0.3 * longer, 1.1 * size}});
    }
}

// Half of them are thick enough in the chosen unit, and fewer than half in a unit twice as long.
TEST(ScaleFor, IsTheLongestUnitInWhichHalfOfTheBodiesAreThickEnough) {
    EXPECT_TRUE(rc::check([] {
        TiedBodies tied;
        std::vector<double> widths;
        int const count = *rc::gen::inRange(0, 30);
        for (int i = 0; i < count; ++i) {
            Shape shape{{somePiece()}};
            if (*rc::gen::inRange(0, 3) == 0) {
                shape.pieces.push_back(somePiece());
            }
            RC_ASSERT(!faultIn(shape)); // such a body would not count
            double least = 1e9;
            for (ShapePiece const& piece : shape.pieces) {
                least = std::min(least, widthOf(piece));
            }
            widths.push_back(least);
            tied.body(shape, {1.0 * i, 0}, 1);
            tied.fixed({1.0 * i, 5}); // as thick as a metre, but it does not count, as it is fixed
        }
        double const thick = count < 20 ? 0.06 : 0.4;
        double const scale = scaleFor(tied.columns());
        auto const thickAt = [&](double unitsPerMetre) {
            // The sampled angles miss the least width by less than a hundredth.
            return std::count_if(widths.begin(), widths.end(),
                                 [&](double width) { return width * unitsPerMetre >= thick; });
        };
        RC_ASSERT(scale == 4 || scale == 8 || scale == 16 || scale == 32 || scale == 64);
        RC_ASSERT(scale == 64 || 2 * thickAt(1.01 * scale) >= count);
        RC_ASSERT(scale == 4 || 2 * thickAt(0.99 * scale / 2) < count);
    }));
}

TEST(RoundedSubsteps, AreFewNumbersAndNotFarAboveTheDemand) {
    std::set<int> all;
    int before = 0;
    for (double wanted = 0; wanted < 70; wanted += 0.01) {
        int const found = roundedSubsteps(wanted);
        EXPECT_GE(found, std::min(wanted, 64.0));
        EXPECT_LE(found, std::max(1.0, 2 * std::ceil(wanted) - 1)) << wanted;
        EXPECT_GE(found, before);
        EXPECT_EQ(roundedSubsteps(found), found);
        before = found;
        all.insert(found);
    }
    EXPECT_EQ(before, 64);
    EXPECT_LE(all.size(), 11U);
    EXPECT_EQ(roundedSubsteps(1e300), 64);
    EXPECT_EQ(roundedSubsteps(-1), 1);
}

} // namespace
} // namespace solver_demand_test
} // namespace trembler::test
