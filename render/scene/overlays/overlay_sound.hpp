// Where something sounds.
#pragma once

#include "render/draw/canvas.hpp"

#include <span>

namespace trembler::render {

/// A ring that spreads from where something sounds, as it stands now.
struct Ripple {
    Point at;            ///< m, in the world
    double radius = 0;   ///< m; none is drawn of what has none yet
    double strength = 0; ///< 0 to 1: how dark it is
};

/// Thin and faint, so that they hide nothing.
void drawRipples(Canvas& canvas, std::span<Ripple const> ripples);

} // namespace trembler::render
