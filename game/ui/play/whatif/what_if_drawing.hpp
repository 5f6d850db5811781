// The other run in the scene: objects that are elsewhere in it, as ghosts, and their paths.
#pragma once

#include "game/ui/play/whatif/what_if_tool.hpp"
#include "render/draw/canvas.hpp"

namespace trembler::ui {

/// Draws on top of the real run, whose world is `real`. Between Canvas::begin and end.
void drawWhatIf(render::Canvas& canvas, World const& real, WhatIfView& view, WhatIfTool const& tool,
                std::uint64_t frame);

} // namespace trembler::ui
