// The gap between two objects from every corner and every side: the reference for contacts.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

namespace trembler::test {

/// A shape where it is.
struct Placed {
    Shape const& shape;
    Vec2 at; ///< m
    double angle = 0;
};

/// The least distance between any two pieces of two shapes, in m; where pieces overlap, minus the length of
/// the shortest way on which one of them gets out of the other. Boxes and polygons are larger than drawn by
/// `skin` (m) all around.
[[nodiscard]] double bruteGap(Placed const& a, Placed const& b, double skin = 0);

} // namespace trembler::test
