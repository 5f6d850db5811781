// Inverse-square sums of all pairs compared with a plain loop in long double, in vectors of every width.
#include "physics/inverse_square/kernels.hpp"
#include "tests/physics/inverse_square/point_clusters.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace trembler::inverse_square {
namespace {

using namespace test;

TEST(InverseSquarePairs, AreThePlainSum) {
    for (bool const signs : {false, true}) {
        Points const points = cluster(203, 1, signs);
        std::vector<Vec2> totals(points.size());
        addAllPairs(points, points, 0, points.size(), softening2, totals);
        expectAllPairs(totals, reference(points, points));
    }
}

TEST(InverseSquarePairs, ReturnTheStiffness) {
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

} // namespace
} // namespace trembler::inverse_square
