// Inverse-square sums by a tree, against a plain loop in long double: at every opening angle, in any order of
// the points.
#include "physics/inverse_square/tree.hpp"
#include "tests/physics/inverse_square/point_clusters.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace trembler::inverse_square {
namespace tree_test {
namespace {

using namespace test;

std::vector<Vec2> byTree(Points const& sources, Points const& receivers, double angle, bool ownElsewhere) {
    Tree tree;
    tree.build(sources);
    tree.setReceivers(receivers, ownElsewhere);
    std::vector<Vec2> totals(receivers.size());
    tree.add(0, receivers.size(), angle, softening2, totals);
    return totals;
}

// Root of the mean squared error, relative to the root of the mean squared force.
double error(std::vector<Vec2> const& totals, std::vector<Sum> const& right) {
    double wrong = 0;
    double all = 0;
    for (std::size_t i = 0; i < right.size(); ++i) {
        wrong += lengthSquared(totals[i] - right[i].total);
        all += lengthSquared(right[i].total);
    }
    return std::sqrt(wrong / all);
}

// Far clusters count with the sum of their absolute weights: weights that cancel in the force do not cancel
// in its stiffness.
TEST(InverseSquareTree, ReturnsTheStiffness) {
    Points const points = cluster(1500, 4, true);
    auto const right = reference(points, points);
    for (double const angle : {0.0, 0.35}) {
        Tree tree;
        tree.build(points);
        tree.setReceivers(points, false);
        std::vector<Vec2> totals(points.size());
        std::vector<double> stiffness(points.size());
        tree.add(0, points.size(), angle, softening2, totals, stiffness);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_NEAR(stiffness[i] / right[i].stiffness, 1, angle == 0 ? 1e-12 : 0.15) << i;
        }
    }
}

TEST(InverseSquareTree, AtAngleZeroIsTheSumOverAllPairs) {
    for (bool const signs : {false, true}) {
        Points const points = cluster(700, 3, signs);
        expectAllPairs(byTree(points, points, 0, false), reference(points, points));
    }
}

TEST(InverseSquareTree, SmallerAnglesHaveSmallerErrors) {
    for (bool const signs : {false, true}) {
        Points const points = cluster(1500, 4, signs);
        auto const right = reference(points, points);
        double before = 1;
        for (double const angle : {1.0, 0.7, 0.5, 0.35, 0.25, 0.12}) {
            double const now = error(byTree(points, points, angle, false), right);
            EXPECT_LT(now, before) << angle << (signs ? ", both signs" : "");
            EXPECT_GT(now, 1e-14) << "no cluster was taken as a whole at " << angle;
            before = now;
        }
        EXPECT_LT(error(byTree(points, points, 0.35, false), right), 3e-3);
        EXPECT_LT(before, 3e-5);
    }
}

// The expansion ends after the second moments, so the error of one distant cluster goes with the third power
// of its size over its distance, relative to its force.
TEST(InverseSquareTree, OneClustersErrorFallsWithTheCubeOfItsDistance) {
    Points blob = cluster(50, 5, false);
    double before = 0;
    for (double const distance : {40.0, 80.0, 160.0, 320.0}) {
        Points far;
        far.add(blob.at(0) + Vec2{distance, distance / 3}, 1, 1e6);
        double const now = error(byTree(blob, far, 1, false), reference(blob, far));
        if (before > 0) {
            EXPECT_NEAR(before / now, 8, 2) << distance;
        }
        before = now;
    }
}

TEST(InverseSquareTree, DoesNotDependOnTheOrderOfPoints) {
    Points const points = cluster(700, 6, true);
    std::vector<Vec2> const first = byTree(points, points, 0.6, false);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937 random(7);
    for (int round = 0; round < 5; ++round) {
        std::shuffle(order.begin(), order.end(), random);
        Points shuffled;
        for (std::size_t const i : order) {
            shuffled.add(points.at(i), points.weight[i], points.owner[i]);
        }
        std::vector<Vec2> const again = byTree(shuffled, shuffled, 0.6, false);
        for (std::size_t k = 0; k < order.size(); ++k) {
            ASSERT_EQ(again[k], first[order[k]]);
        }
    }
}

// Both poles of a long bar belong to one owner: at any distance, one never acts on the other, not even as a
// part of a cluster.
TEST(InverseSquareTree, LeavesOutSourcesOfTheReceiversOwner) {
    Points points = cluster(600, 8, true);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points.owner[i] = static_cast<double>(i % 300); // its twin is far away, in another cluster
    }
    points.weight[7] = 1e9; // unmistakable
    auto const right = reference(points, points);
    std::vector<Vec2> const totals = byTree(points, points, 1, true);
    EXPECT_LT(length(totals[307] - right[307].total), 1e-2 * right[307].scale);
    EXPECT_LT(right[307].scale, 1e7) << "the twin is not in the reference";
    expectAllPairs(byTree(points, points, 0, true), right);
}

TEST(InverseSquareTree, AcceptsPointsInOnePlaceNoPointAndOnePoint) {
    EXPECT_TRUE(byTree({}, {}, 0.5, false).empty());
    Points one;
    one.add({3, 4}, 2, 0);
    EXPECT_EQ(byTree(one, one, 0.5, false)[0], (Vec2{0, 0}));
    Points heap;
    for (int i = 0; i < 200; ++i) {
        heap.add({1, 1}, 1e9, i);
    }
    for (Vec2 const& total : byTree(heap, heap, 0.5, false)) {
        EXPECT_EQ(total, (Vec2{0, 0}));
    }
    heap.add({1e5, 1}, 1, 200);
    auto const totals = byTree(heap, heap, 0.5, false);
    expectAllPairs(totals, reference(heap, heap));
    EXPECT_NEAR(totals[200].x, -200e9 / 1e10, 2e-3);
}

TEST(InverseSquareTree, KeepsTheErrorSmallForWeightsOfAnyRatio) {
    EXPECT_TRUE(rc::check([] {
        auto const number = [](double low, double high) {
            return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
        };
        Points points;
        auto const count = *rc::gen::inRange<std::size_t>(1, 120);
        for (std::size_t i = 0; i < count; ++i) {
            points.add({number(-10, 10), number(-10, 10)}, std::pow(10.0, number(-12, 12)),
                       static_cast<double>(i));
        }
        auto const right = reference(points, points);
        auto const totals = byTree(points, points, 0.5, false);
        for (std::size_t i = 0; i < count; ++i) {
            RC_ASSERT(length(totals[i] - right[i].total) <= 0.02 * right[i].scale);
        }
    }));
}

} // namespace
} // namespace tree_test
} // namespace trembler::inverse_square
