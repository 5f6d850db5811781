// The gap between two objects, computed from every corner and every side: the reference for contacts.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

namespace trembler::test {

/// A shape at its place.
struct Placed {
    Shape const& shape;
    Vec2 at; ///< m
    double angle = 0;
};

/// The least distance between any two pieces of two shapes, in m; for overlapping pieces, minus the shortest
/// displacement that separates them. Boxes and polygons are larger than drawn by `skin` (m) on all sides.
[[nodiscard]] double bruteGap(Placed const& a, Placed const& b, double skin = 0);

} // namespace trembler::test
