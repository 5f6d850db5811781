// The table of everything that a level's screen can be asked to do.
#pragma once

#include "game/ui/commands/command.hpp"
#include "game/ui/commands/key_help.hpp"

#include <span>

namespace trembler::ui {

struct PlayParts;

[[nodiscard]] std::span<Command<PlayParts> const> playCommands();
/// What hands do besides.
[[nodiscard]] std::span<Gesture const> playGestures();

} // namespace trembler::ui
