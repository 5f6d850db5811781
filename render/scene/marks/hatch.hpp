// Diagonal strokes of a pencil: the draughtsman's sign for ground and for areas.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/facts/shape_geometry.hpp"

#include <span>

namespace trembler::render {

/// Parallel lines inside a convex outline, both in the world; `angle` in radians, `spacing` in metres
/// (widened where the outline would take more than some hundred lines). One of the lines, extended,
/// passes through `origin`.
void hatch(Canvas& canvas, std::span<Point const> convex, Point origin, double angle, double spacing,
           Stroke const& stroke);

/// The sign of fixed objects: hatching of one pattern over all pieces of a shape, turning with it.
void hatchShape(Canvas& canvas, Shape const& shape, Pose const& pose, float alpha);

} // namespace trembler::render
