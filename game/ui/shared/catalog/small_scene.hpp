// A world as a small picture of it.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/gl/framebuffer.hpp"
#include "runtime/world/world.hpp"

namespace trembler::ui {

/// Draws the whole world as it is, as a screen of 360 rows would show it. The caller binds its own target
/// again afterwards. Window thread only. Throws render::RenderError.
void drawSmallScene(render::Canvas& canvas, render::Framebuffer const& target, World const& world);

} // namespace trembler::ui
