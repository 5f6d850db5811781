// Draws the world of a level's screen: its objects, marks on them, the part in the hand, and words.
#pragma once

#include "game/ui/play/play_parts.hpp"

namespace trembler::ui {

/// To be called after Window::beginFrame and before Gui::endFrame. Changes only the state that drawing itself
/// keeps from picture to picture.
void drawField(PlayParts& parts);

} // namespace trembler::ui
