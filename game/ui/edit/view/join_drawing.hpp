// While a wire or a joint is drawn: what it may join lights up, and a place that refuses it says why.
#pragma once

#include "game/ui/edit/tools/join_tool.hpp"

namespace trembler::ui {

/// Draws the outlines and the wire or joint that was begun.
void drawJoining(render::Canvas& canvas, EditParts const& parts, JoinTool const& join);
/// The words beside the pointer.
void drawJoiningWords(EditParts const& parts, JoinTool const& join);

} // namespace trembler::ui
