// Draws the cards of a level's screen.
#pragma once

#include "game/ui/play/play_parts.hpp"

#include <optional>

namespace trembler::ui {

/// To be called between Gui::beginFrame and Gui::endFrame. Returns the index of the command whose button was
/// pressed. A part that is pressed in the toolbox goes into the hand at once.
std::optional<std::size_t> drawPlayCards(PlayParts& parts, CommandSet const& commands);

} // namespace trembler::ui
