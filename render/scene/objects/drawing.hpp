// An object as its drawing shows it (physics/drawing.hpp).
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/facts/facts.hpp"

namespace trembler::render {

/// Draws the shapes of the object's drawing, which it must have, in the order stated. `style` is that of the
/// body: the highlights for the player, and all values that a shape does not state itself, are taken from it.
void drawShapes(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style);

} // namespace trembler::render
