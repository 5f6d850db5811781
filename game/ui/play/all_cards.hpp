// All cards of a level's screen, each where it belongs.
#pragma once

#include "game/ui/play/play_parts.hpp"

#include <optional>

namespace trembler::ui {

/// Between Gui::beginFrame and endFrame. Returns the command that a button asked for; a part that is pressed
/// on in the toolbox is taken at once.
std::optional<std::size_t> drawPlayCards(PlayParts& parts, CommandSet const& commands);

} // namespace trembler::ui
