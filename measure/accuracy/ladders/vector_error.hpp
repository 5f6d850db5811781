// The relative error of a set of vectors.
#pragma once

#include "runtime/math/vec2.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace trembler::accuracy {

/// Root of the mean squared difference, relative to the root of the mean squared exact vector `right`, from
/// the entry `from` on. Infinite if the numbers of vectors differ.
[[nodiscard]] inline double relativeError(std::vector<Vec2> const& found, std::vector<Vec2> const& right,
                                          std::size_t from = 0) {
    if (found.size() != right.size()) {
        return std::numeric_limits<double>::infinity();
    }
    double wrong = 0;
    double all = 0;
    for (std::size_t i = from; i < right.size(); ++i) {
        wrong += lengthSquared(found[i] - right[i]);
        all += lengthSquared(right[i]);
    }
    return all > 0 ? std::sqrt(wrong / all) : std::sqrt(wrong);
}

} // namespace trembler::accuracy
