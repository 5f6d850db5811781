// The corners of a shape's pieces that have straight sides only.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

#include <vector>

namespace trembler {

/// The corners of a box or a polygon, m, in the piece's own frame, anticlockwise. Empty for a circle and a
/// capsule: how many corners stand for their round sides is for each caller to decide.
[[nodiscard]] std::vector<Vec2> straightCornersOf(ShapePiece const& piece);

} // namespace trembler
