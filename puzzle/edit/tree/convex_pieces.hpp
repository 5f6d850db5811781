// Divides a polygon into convex ones.
#pragma once

#include "runtime/math/vec2.hpp"

#include <span>
#include <vector>

namespace trembler::edit {

struct ConvexPieces {
    Vec2 centre; ///< of the area
    /// Anticlockwise, each of 3 to 8 corners, convex; together they are the polygon.
    std::vector<std::vector<Vec2>> pieces;
};

/// Corners in either direction; those on the line between their neighbours are left out. By clipping ears,
/// and joining the triangles again where the result is convex (Hertel and Mehlhorn 1983). Throws CommandError
/// if there are fewer than three or more than 200 corners, the edges cross or touch, or the polygon is flat.
[[nodiscard]] ConvexPieces convexPieces(std::span<Vec2 const> corners);

} // namespace trembler::edit
