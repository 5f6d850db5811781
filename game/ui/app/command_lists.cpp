#include "game/ui/app/command_lists.hpp"

#include "game/ui/app/title_screen.hpp"
#include "game/ui/edit/commands/edit_commands.hpp"
#include "game/ui/edit/edit_parts.hpp"
#include "game/ui/play/commands/play_commands.hpp"
#include "game/ui/play/play_parts.hpp"

namespace trembler::ui {

std::vector<CommandList> commandLists() {
    return {listOf(playCommands()), listOf(titleCommands()), listOf(editCommands())};
}

std::span<Gesture const> allGestures() {
    return playGestures();
}

} // namespace trembler::ui
