// Where the shapes of a drawing lie in their object's frame, and how far they reach.
#pragma once

#include "physics/drawn_shape.hpp"
#include "render/draw/geometry.hpp"
#include "render/scene/facts/shape_geometry.hpp"

#include <vector>

namespace trembler::render {

/// The frame of one copy of a repeated shape (0: the shape as stated), in the object's frame.
[[nodiscard]] Pose poseOfCopy(DrawnShape const& shape, std::int32_t copy);

/// No point of a copy, without its glow, is further from the middle of its frame; metres.
[[nodiscard]] double reachOf(DrawnShape const& shape);

/// The rectangle around a copy without its glow and outline, whose frame lies at `pose` in the world. Exact,
/// but for the ends of lines, which may be cut square: up to half of their thickness too large.
[[nodiscard]] Extent extentOf(DrawnShape const& shape, Pose const& pose);

/// The points of a line in its shape's frame: those stated, or a smooth curve through them (a centripetal
/// Catmull-Rom spline, which makes no loops).
[[nodiscard]] std::vector<Point> pathOf(DrawnShape const& line);

} // namespace trembler::render
