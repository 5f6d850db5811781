// The picture of the title screen, a trembler bell: an electromagnet that pulls an armature, opens its own
// circuit, releases the armature, and so on.
#pragma once

#include "render/draw/canvas.hpp"

namespace trembler::ui {

/// Width of the picture around the origin, m.
inline constexpr double titleWidth = 6.4;
inline constexpr double titleHeight = 3.8;
/// The bell rings and rests once in this time, s.
inline constexpr double titlePeriod = 1.6;
/// A time at which it rests.
inline constexpr double titleAtRest = 1.3;

/// Draws an animation, not a simulation; `time` in s.
void drawTrembler(render::Canvas& canvas, double time);

} // namespace trembler::ui
