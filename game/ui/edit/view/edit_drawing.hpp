// Draws the edited scene: the world at its start, and the marks of the designer's work on it.
#pragma once

#include "game/ui/edit/tools/edit_mouse.hpp"

namespace trembler::ui {

/// After Window::beginFrame, before Gui::endFrame.
void drawEditedScene(EditParts& parts, EditMouse const& mouse);

} // namespace trembler::ui
