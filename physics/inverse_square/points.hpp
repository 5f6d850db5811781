// Points that attract or repel with the inverse square of the distance, as arrays for vector instructions.
// Gravity and magnetism sum over them.
#pragma once

#include "runtime/math/vec2.hpp"

#include <cstddef>
#include <vector>

namespace trembler::inverse_square {

/// Sources or receivers. The sum that a receiver i gets from all sources j is
///     f_i · Σ w_j · r_ij / (r_ij² + s²)^(3/2),   r_ij from i to j,
/// with w the weights of the sources (masses, pole strengths with their signs), f the weight of the receiver
/// and s the softening length; sources of the receiver's own owner are left out.
struct Points {
    std::vector<double> x; ///< m
    std::vector<double> y; ///< m
    std::vector<double> weight;
    std::vector<double> owner; ///< number of the object, below 2^53: as a double it compares in vectors

    [[nodiscard]] std::size_t size() const { return x.size(); }
    [[nodiscard]] bool empty() const { return x.empty(); }
    [[nodiscard]] Vec2 at(std::size_t i) const { return {x[i], y[i]}; }
    void clear() {
        x.clear();
        y.clear();
        weight.clear();
        owner.clear();
    }
    void add(Vec2 where, double pointWeight, double pointOwner) {
        x.push_back(where.x);
        y.push_back(where.y);
        weight.push_back(pointWeight);
        owner.push_back(pointOwner);
    }
};

} // namespace trembler::inverse_square
