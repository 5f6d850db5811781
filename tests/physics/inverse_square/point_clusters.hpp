// Points in clusters, and their inverse-square sums by a plain loop in long double.
#pragma once

#include "physics/inverse_square/points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>
#include <vector>

namespace trembler::inverse_square::test {

inline constexpr double softening2 = 0.05 * 0.05;

// Clusters of different sizes in a wide field. mt19937 and these divisions are the same everywhere.
inline Points cluster(std::size_t count, unsigned seed, bool bothSigns) {
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
    double scale = 0;     ///< sum of the absolute values of the summands
    double stiffness = 0; ///< sum of them, per distance
};
inline std::vector<Sum> reference(Points const& sources, Points const& receivers) {
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

inline void expectAllPairs(std::vector<Vec2> const& totals, std::vector<Sum> const& right) {
    for (std::size_t i = 0; i < right.size(); ++i) {
        ASSERT_LE(length(totals[i] - right[i].total), 1e-13 * right[i].scale) << i;
    }
}

} // namespace trembler::inverse_square::test
