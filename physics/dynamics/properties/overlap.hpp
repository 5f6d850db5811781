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
/// The smallest upright rectangle around a placed shape: its lower left and upper right corner.
[[nodiscard]] std::pair<Vec2, Vec2> extentOf(PlacedShape const& placed);

} // namespace trembler
