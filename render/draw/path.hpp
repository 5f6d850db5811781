// Points along the curves that wires, springs and field lines follow.
#pragma once

#include "render/draw/geometry.hpp"

#include <span>
#include <vector>

namespace trembler::render {

/// A cubic Bézier curve in `pieces` (at least 1) straight pieces, both ends included.
[[nodiscard]] std::vector<Point> bezier(Point from, Point fromHandle, Point toHandle, Point to,
                                        int pieces = 16);

/// A wire that hangs between two points: a parabola whose lowest part is `sag` metres below the straight
/// line.
[[nodiscard]] std::vector<Point> hangingWire(Point from, Point to, double sag, int pieces = 16);

/// A coil spring between two points: a zigzag of `turns` windings and the given half width in metres, with a
/// straight tenth at each end.
[[nodiscard]] std::vector<Point> coil(Point from, Point to, double halfWidth, int turns);

/// Length along the path, metres.
[[nodiscard]] double pathLength(std::span<Point const> path);

/// The point `distance` metres along the path from its first point, clamped to its ends. {0, 0} for an empty
/// path.
[[nodiscard]] Point pointAlong(std::span<Point const> path, double distance);

} // namespace trembler::render
