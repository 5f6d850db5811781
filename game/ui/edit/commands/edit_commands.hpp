// The table of the editor's commands.
#pragma once

#include "game/ui/shared/commands/command.hpp"
#include "game/ui/shared/commands/key_help.hpp"

#include <span>

namespace trembler::ui {

struct EditParts;

[[nodiscard]] std::span<Command<EditParts> const> editCommands();
/// Those besides the commands of playing while a level is test-played.
[[nodiscard]] std::span<Command<EditParts> const> testCommands();
/// The editor's mouse actions.
[[nodiscard]] std::span<Gesture const> editGestures();

} // namespace trembler::ui
