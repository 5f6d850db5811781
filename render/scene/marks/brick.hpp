// Courses of bricks with light mortar between them.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/facts/shape_geometry.hpp"

namespace trembler::render {

/// Draws the joints of a wall over a shape; nothing on a shape that is not larger than a brick (0.36 m by
/// 0.16 m).
void drawMortar(Canvas& canvas, Shape const& shape, Pose const& pose, float alpha);

} // namespace trembler::render
