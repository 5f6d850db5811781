// Draws the edited scene: the world as it starts, and what the designer does with it.
#pragma once

#include "game/ui/edit/tools/edit_mouse.hpp"

namespace trembler::ui {

/// After Window::beginFrame, before Gui::endFrame.
void drawEditedScene(EditParts& parts, EditMouse const& mouse);

} // namespace trembler::ui
