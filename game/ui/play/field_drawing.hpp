// What a level's screen draws in the world: the things, marks on them, what is in the hand, and words.
#pragma once

#include "game/ui/play/play_parts.hpp"

namespace trembler::ui {

/// After Window::beginFrame, before Gui::endFrame. Changes nothing but what drawing itself keeps.
void drawField(PlayParts& parts);

} // namespace trembler::ui
