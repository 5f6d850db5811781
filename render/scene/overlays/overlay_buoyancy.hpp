// Where liquids lift objects, and how strongly.
#pragma once

#include "render/draw/canvas.hpp"
#include "runtime/world/world.hpp"

namespace trembler::render {

/// A dot at every centre of buoyancy, as the thesis draws it (Figure 6-19), and F_B as an arrow, as long as
/// that of any other force of the same strength (arrowLength()).
void drawBuoyancy(Canvas& canvas, World const& world);

} // namespace trembler::render
