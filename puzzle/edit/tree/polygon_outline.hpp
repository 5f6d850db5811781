// The outline of a shape that is made of polygons, and the shape with a corner of it elsewhere.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

#include <optional>
#include <vector>

namespace trembler::edit {

/// The corners around the polygons of a shape, m, anticlockwise in the object's frame: of a concave shape,
/// without the lines along which its convex pieces meet. Nothing if a piece is no polygon, or the pieces do
/// not form one outline.
[[nodiscard]] std::optional<std::vector<Vec2>> polygonOutline(Shape const& shape);

} // namespace trembler::edit
