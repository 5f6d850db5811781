// The commands and gestures of all screens of the program.
#pragma once

#include "game/ui/shared/commands/key_bindings.hpp"
#include "game/ui/shared/commands/key_help.hpp"

#include <span>
#include <vector>

namespace trembler::ui {

/// One list for each screen; a new screen's table is added here. The lists refer to static data.
[[nodiscard]] std::vector<CommandList> commandLists();
/// Only the screen of a level has gestures.
[[nodiscard]] std::span<Gesture const> allGestures();

} // namespace trembler::ui
