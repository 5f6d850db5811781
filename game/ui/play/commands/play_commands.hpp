// The table of all commands of a level's screen.
#pragma once

#include "game/ui/shared/commands/command.hpp"
#include "game/ui/shared/commands/key_help.hpp"

#include <span>

namespace trembler::ui {

struct PlayParts;

/// In the order of the page of keys. They live as long as the program.
[[nodiscard]] std::span<Command<PlayParts> const> playCommands();
/// The other actions of the mouse and of modifier keys, for the page of keys.
[[nodiscard]] std::span<Gesture const> playGestures();

} // namespace trembler::ui
