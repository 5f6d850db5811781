// Dashed lines, for outlines and connections that are not bodies.
#pragma once

#include "render/draw/canvas.hpp"

#include <span>

namespace trembler::render {

/// Dashes along a path; lengths in metres. A closed path continues to its first point, and its dashes are
/// stretched a little so that they come out even. Very long paths get longer dashes instead of thousands.
void dashed(Canvas& canvas, std::span<Point const> path, bool closed, double dash, double gap,
            Stroke const& stroke);

} // namespace trembler::render
