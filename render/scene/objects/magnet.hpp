// Permanent magnets: halves in the colours of their poles, with letters, as some eyes cannot distinguish the
// colours.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/facts/facts.hpp"

namespace trembler::render {

/// Paints the object's shape in the colours of its poles and writes their letters. Needs a shape and poles.
void drawMagnet(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style);

} // namespace trembler::render
