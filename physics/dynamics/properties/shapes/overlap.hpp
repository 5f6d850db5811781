// Whether two placed shapes overlap, for placing parts by hand.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

namespace trembler {

struct PlacedShape {
    Shape const& shape;
    Vec2 at;          ///< m, in the world
    double angle = 0; ///< rad
};

/// True if any two pieces overlap by more than about `allowed` (m). By the distance algorithm of Gilbert,
/// Johnson and Keerthi (1988) in Box2D, on pieces that are reduced by half of `allowed` on all sides. The
/// shapes must be valid.
[[nodiscard]] bool overlap(PlacedShape const& a, PlacedShape const& b, double allowed);
/// The narrowest gap between two placed shapes: its width in m, 0 if they touch or overlap, and its ends.
struct ShapeGap {
    double width = 0;
    Vec2 a; ///< m, in the world, on the surface of the first shape
    Vec2 b; ///< m, on that of the second
};
/// By the same algorithm, in single precision relative to the first shape. The shapes must be valid.
[[nodiscard]] ShapeGap gapBetween(PlacedShape const& a, PlacedShape const& b);
/// The smallest upright rectangle around a placed shape: its lower left and upper right corner.
[[nodiscard]] std::pair<Vec2, Vec2> extentOf(PlacedShape const& placed);

} // namespace trembler
