// The order of a shape's pieces, and of a polygon's corners. The order means nothing, but sums are rounded in
// some order, and engines look at pieces one after the other: all of physics takes them in this order, so
// that the order in a file changes no bit of the motion.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

namespace trembler {

/// The same shape with the largest piece (by area) first and the others from left to right by their centres;
/// each polygon begins with its lowest corner, the leftmost of several. Equal for every order of the same
/// pieces, and for every corner that a polygon may begin with. A shape with numbers that are not finite stays
/// as it is.
[[nodiscard]] Shape inOrder(Shape shape);
/// Whether inOrder() would leave it as it is. Cheap.
[[nodiscard]] bool isInOrder(Shape const& shape);

} // namespace trembler
