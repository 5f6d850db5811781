// The order of a shape's pieces, and of a polygon's corners. The order has no meaning, but rounding of sums
// and the results of engines depend on it: all of physics uses this order, so that the order in a file
// changes no bit of the motion.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

namespace trembler {

/// The same shape with the largest piece (by area) first and the others from left to right by their centres;
/// each polygon begins with its lowest corner, the leftmost of several. Equal for every order of the same
/// pieces, and for every first corner of a polygon. A shape with numbers that are not finite is not changed.
[[nodiscard]] Shape inOrder(Shape shape);
/// Whether inOrder() would not change the shape. Cheap.
[[nodiscard]] bool isInOrder(Shape const& shape);

} // namespace trembler
