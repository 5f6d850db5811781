// The trembler: an electromagnet that pulls an armature, opens its own circuit, lets go, and so on; and a
// bell.
#pragma once

#include "render/draw/canvas.hpp"

namespace trembler::ui {

/// The room that the picture takes around the origin, m.
inline constexpr double titleWidth = 6.4;
inline constexpr double titleHeight = 3.8;

/// A drawing and not a simulation; `time` in s makes it tremble.
void drawTrembler(render::Canvas& canvas, double time);

} // namespace trembler::ui
