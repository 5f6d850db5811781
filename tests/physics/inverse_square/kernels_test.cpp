// Inverse-square sums compared with a plain loop in long double, and with one another: every vector width,
// the tree at every opening angle, any order of the points.
#include "physics/inverse_square/kernels.hpp"
#include "physics/inverse_square/tree.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace trembler::inverse_square {
namespace {

constexpr double softening2 = 0.05 * 0.05;

// Clusters of different sizes in a wide field. mt19937 and these divisions are the same everywhere.
Points cluster(std::size_t count, unsigned seed, bool bothSigns) {
    std::mt19937 random(seed);
    auto const number = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967295.0);
    };
    Points points;
    Vec2 centre;
    double size = 1;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % 50 == 0) {
            centre = {number(-100, 100), number(-100, 100)};
            size = std::exp(number(-3, 3));
        }
        double const weight = number(0.1, 10);
        points.add(centre + Vec2{number(-size, size), number(-size, size)},
                   bothSigns && i % 2 == 1 ? -weight : weight, static_cast<double>(i));
    }
    return points;
}

struct Sum {
    Vec2 total;
    double scale = 0;     ///< sum of the absolute values of what was added
    double stiffness = 0; ///< sum of them, per distance
};
std::vector<Sum> reference(Points const& sources, Points const& receivers) {
    std::vector<Sum> sums(receivers.size());
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        long double x = 0;
        long double y = 0;
        long double scale = 0;
        long double stiffness = 0;
        for (std::size_t j = 0; j < sources.size(); ++j) {
            if (sources.owner[j] == receivers.owner[i]) {
                continue;
            }
            long double const rx = static_cast<long double>(sources.x[j]) - receivers.x[i];
            long double const ry = static_cast<long double>(sources.y[j]) - receivers.y[i];
            long double const d = std::sqrt(rx * rx + ry * ry + static_cast<long double>(softening2));
            long double const part = sources.weight[j] * (receivers.weight[i] / (d * d * d));
            x += part * rx;
            y += part * ry;
            scale += std::abs(part) * std::hypot(rx, ry);
            stiffness += std::abs(part);
        }
        sums[i] = {{static_cast<double>(x), static_cast<double>(y)},
                   static_cast<double>(scale),
                   static_cast<double>(stiffness)};
    }
    return sums;
}

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

void expectAllPairs(std::vector<Vec2> const& totals, std::vector<Sum> const& right) {
    for (std::size_t i = 0; i < right.size(); ++i) {
        ASSERT_LE(length(totals[i] - right[i].total), 1e-13 * right[i].scale) << i;
    }
}

TEST(InverseSquarePairs, AreThePlainSum) {
    for (bool const signs : {false, true}) {
        Points const points = cluster(203, 1, signs);
        std::vector<Vec2> totals(points.size());
        addAllPairs(points, points, 0, points.size(), softening2, totals);
        expectAllPairs(totals, reference(points, points));
    }
}

TEST(InverseSquarePairs, TellHowStiffTheyAre) {
    Points const points = cluster(203, 1, true);
    auto const right = reference(points, points);
    std::vector<Vec2> totals(points.size());
    std::vector<double> stiffness(points.size(), 1);
    addAllPairs(points, points, 0, points.size(), softening2, totals, stiffness);
    expectAllPairs(totals, right);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(stiffness[i] - 1, right[i].stiffness, 1e-9 * (1 + right[i].stiffness)) << i;
    }
}

// Far clusters count with all of their weights: what cancels in the force does not cancel in how it varies.
TEST(InverseSquareTree, TellsHowStiffItIs) {
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

TEST(InverseSquarePairs, AreTheSameBitsInVectorsOfEveryWidth) {
    Points const points = cluster(203, 2, true);
    Window const window(20, 30);
    std::vector<Cluster> const clusters{{200, 1, 3, 0.5, -0.25, 2, 0.125, 1},
                                        {-90, 150, -1, 2, 1, 0.5, 3, 4, 5}};
    std::vector<Block> first;
    for (Kernels const& kernels : availableKernels()) {
        std::vector<Block> blocks;
        for (std::size_t i = 0; i + blockSize <= points.size(); i += blockSize) {
            Block block;
            std::vector<Vec2> const none(points.size());
            auto const row = [i](std::size_t k) { return i + k; };
            fillBlock(block, points, none, blockSize, row, row);
            kernels.addPairs(points, 0, points.size(), softening2, block);
            kernels.addWindowed(points, 3, 150, softening2, window, block);
            kernels.addClusters(clusters, softening2, block);
            blocks.push_back(block);
        }
        first = first.empty() ? blocks : first;
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            for (std::size_t k = 0; k < blockSize; ++k) {
                ASSERT_EQ(blocks[i].sumX[k], first[i].sumX[k]) << kernels.name;
                ASSERT_EQ(blocks[i].sumY[k], first[i].sumY[k]) << kernels.name;
                ASSERT_EQ(blocks[i].stiffness[k], first[i].stiffness[k]) << kernels.name;
            }
        }
    }
}

TEST(InverseSquareTree, AtAngleZeroIsEveryPair) {
    for (bool const signs : {false, true}) {
        Points const points = cluster(700, 3, signs);
        expectAllPairs(byTree(points, points, 0, false), reference(points, points));
    }
}

TEST(InverseSquareTree, ErrsLessTheSmallerTheAngle) {
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

TEST(InverseSquareTree, DoesNotKnowInWhichOrderThePointsCame) {
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

// Both poles of a long bar belong to one owner: however far apart, one never feels the other, not even as a
// part of a cluster.
TEST(InverseSquareTree, LeavesOutWhatBelongsToTheReceiversOwner) {
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

TEST(InverseSquareTree, TakesPointsInOnePlaceNoneAndOne) {
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
} // namespace trembler::inverse_square
