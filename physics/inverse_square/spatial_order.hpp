// An order of points along a curve that fills the plane: neighbours in it are near one another. It depends on
// the points alone, not on their order in the input.
#pragma once

#include "physics/inverse_square/points.hpp"

#include <cstdint>
#include <vector>

namespace trembler::inverse_square {

struct Ordered {
    std::uint64_t key = 0;
    std::uint32_t row = 0; ///< in the points as given
};

/// Keys after Morton (1966): the bits of both coordinates in turn, coarsest first. Ascending by key; points
/// of one key by place, weight and owner, so that only identical points have no fixed order. Coordinates are
/// distinguished to 2^-32 of the greater extent of all points. O(n log n); `order` is overwritten and its
/// memory reused. At most 2^32 points.
void orderAlongCurve(Points const& points, std::vector<Ordered>& order);

/// Ascending by key, then by the points' place, weight and owner.
void sortByKeyAndPoint(Points const& points, std::vector<Ordered>& order);

/// The points in that order.
void copyInOrder(Points const& points, std::vector<Ordered> const& order, Points& into);

} // namespace trembler::inverse_square
