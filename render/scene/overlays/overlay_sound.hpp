// Where sounds are made.
#pragma once

#include "render/draw/canvas.hpp"

#include <span>

namespace trembler::render {

/// The present state of a ring that spreads from a source of sound.
struct Ripple {
    Point at;            ///< m, in the world
    double radius = 0;   ///< m; 0: not drawn yet
    double strength = 0; ///< 0 to 1: how dark it is
};

/// Thin and faint, so that they hide nothing.
void drawRipples(Canvas& canvas, std::span<Ripple const> ripples);

} // namespace trembler::render
