// A box of the thesis's notation, drawn.
#pragma once

#include "runtime/notation/boxes.hpp"

namespace trembler::ui {

/// A frame as wide as the card, with the title in its first line, like the boxes that `trembler components`
/// prints. Between Gui::beginFrame and endFrame, inside a card.
void drawNotationBox(NotationBox const& box);

} // namespace trembler::ui
