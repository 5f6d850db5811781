// Inverse-square sums that end at a cutoff, against a plain loop with the same window.
#include "physics/inverse_square/grid.hpp"
#include "tests/physics/inverse_square/point_clusters.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trembler::inverse_square {
namespace grid_test {
namespace {

using namespace test;

std::vector<Vec2> byGrid(Points const& sources, Points const& receivers, double inner, double cutoff,
                         std::size_t chunk = 1000) {
    Grid grid;
    grid.build(sources, cutoff);
    grid.setReceivers(receivers);
    std::vector<Vec2> totals(receivers.size());
    for (std::size_t begin = 0; begin < receivers.size(); begin += chunk) {
        grid.add(begin, std::min(begin + chunk, receivers.size()), inner, softening2, totals);
    }
    return totals;
}

/// The window: 1 up to `inner`, 0 from `cutoff` on, and the smooth step 3t² - 2t³ in r² in between.
std::vector<Sum> windowed(Points const& sources, Points const& receivers, double inner, double cutoff) {
    std::vector<Sum> sums(receivers.size());
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        long double x = 0;
        long double y = 0;
        for (std::size_t j = 0; j < sources.size(); ++j) {
            if (sources.owner[j] == receivers.owner[i]) {
                continue;
            }
            long double const rx = static_cast<long double>(sources.x[j]) - receivers.x[i];
            long double const ry = static_cast<long double>(sources.y[j]) - receivers.y[i];
            long double const r2 = rx * rx + ry * ry;
            long double const span = static_cast<long double>(cutoff) * cutoff - inner * inner;
            long double const t = std::clamp((cutoff * cutoff - r2) / span, 0.0L, 1.0L);
            long double const d = std::sqrt(r2 + static_cast<long double>(softening2));
            long double const part =
                t * t * (3 - 2 * t) * sources.weight[j] * receivers.weight[i] / (d * d * d);
            x += part * rx;
            y += part * ry;
            sums[i].scale += static_cast<double>(std::abs(part) * std::hypot(rx, ry));
        }
        sums[i].total = {static_cast<double>(x), static_cast<double>(y)};
    }
    return sums;
}

void expectSums(std::vector<Vec2> const& totals, std::vector<Sum> const& right) {
    ASSERT_EQ(totals.size(), right.size());
    for (std::size_t i = 0; i < right.size(); ++i) {
        // Where the window is nearly 0, its relative error is that of r².
        ASSERT_LE(length(totals[i] - right[i].total), 1e-11 * right[i].scale + 1e-12) << i;
    }
}

TEST(InverseSquareGrid, IsTheSumWithinTheCutoff) {
    for (double const cutoff : {0.5, 5.0, 60.0, 1000.0}) {
        for (bool const signs : {false, true}) {
            Points const points = cluster(400, 11, signs);
            expectSums(byGrid(points, points, 0.8 * cutoff, cutoff),
                       windowed(points, points, 0.8 * cutoff, cutoff));
        }
    }
}

TEST(InverseSquareGrid, ReceiversMayBeAnywhere) {
    Points const sources = cluster(300, 12, true);
    Points receivers;
    for (int i = -60; i <= 60; ++i) {
        receivers.add({3.0 * i, 2.5 * i - 7}, 1.5, 1e6 + i);
        receivers.add({1e9 * i, -1e12 * i}, 1, 2e6 + i); // beyond every square
    }
    receivers.add(sources.at(5), 2, sources.owner[5]); // the source of the same owner is left out
    expectSums(byGrid(sources, receivers, 6, 10), windowed(sources, receivers, 6, 10));
}

TEST(InverseSquareGrid, BitsDoNotDependOnTheOrderOfPointsOrOnRanges) {
    Points const points = cluster(300, 13, true);
    std::vector<Vec2> const first = byGrid(points, points, 4, 6);
    for (std::size_t const chunk : {1U, 3U, 64U}) {
        EXPECT_EQ(byGrid(points, points, 4, 6, chunk), first) << chunk;
    }
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937 random(7);
    std::shuffle(order.begin(), order.end(), random);
    Points shuffled;
    for (std::size_t const i : order) {
        shuffled.add(points.at(i), points.weight[i], points.owner[i]);
    }
    std::vector<Vec2> const again = byGrid(shuffled, shuffled, 4, 6);
    for (std::size_t k = 0; k < order.size(); ++k) {
        EXPECT_EQ(again[k], first[order[k]]);
    }
}

// The force between two points slightly farther apart than the cutoff is exactly zero.
TEST(InverseSquareGrid, BeyondTheCutoffIsExactlyZeroForAnySquares) {
    EXPECT_TRUE(rc::check("within: something; beyond: nothing", [] {
        auto const number = [](double low, double high) {
            return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
        };
        double const cutoff = number(0.1, 10);
        Vec2 const at{number(-50, 50), number(-50, 50)};
        Vec2 const way = rotated({1, 0}, number(-3.2, 3.2));
        double const share = number(0.5, 1.5);
        RC_PRE(std::abs(share - 1) > 1e-3);
        Points points;
        points.add(at, 2, 0);
        points.add(at + share * cutoff * way, 3, 1);
        std::vector<Vec2> const totals = byGrid(points, points, 0.9 * cutoff, cutoff);
        RC_ASSERT((totals[0] == Vec2{}) == (share > 1));
        RC_ASSERT(totals[1] == -totals[0] || length(totals[1] + totals[0]) < 1e-12 * length(totals[0]));
    }));
}

TEST(InverseSquareGrid, AcceptsNoSourcesAndAddsToExistingValues) {
    EXPECT_TRUE(byGrid({}, {}, 1, 2).empty());
    Points one;
    one.add({3, 4}, 2, 0);
    EXPECT_EQ(byGrid({}, one, 1, 2)[0], (Vec2{}));
    Points const points = cluster(100, 14, true);
    Grid grid;
    grid.build(points, 50);
    grid.setReceivers(points);
    std::vector<Vec2> totals(points.size());
    std::vector<double> stiffness(points.size(), 1);
    grid.add(0, points.size(), 40, softening2, totals, stiffness);
    std::vector<Vec2> twice = totals;
    grid.add(0, points.size(), 40, softening2, twice);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_LE(length(twice[i] - 2 * totals[i]), 1e-9 * length(totals[i]) + 1e-12);
        EXPECT_GE(stiffness[i], 1);
    }
}

} // namespace
} // namespace grid_test
} // namespace trembler::inverse_square
