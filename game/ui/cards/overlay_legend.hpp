// What the lines, arrows and marks of the overlays mean.
#pragma once

#include "game/ui/play/view/shown.hpp"
#include "game/ui/shared/layout.hpp"

namespace trembler::ui {

/// Draws the card "legend" above the tools: a row for each sign of the overlays that are shown, with arrows
/// in the length that they have in the scene; nothing if none is shown, or if another card takes the room.
/// `below`: height of what lies between it and the row of tools, pixels at UI scale 1.
void drawOverlayLegend(Layout& layout, Shown const& shown, float below);

} // namespace trembler::ui
