#include "game/ui/app/command_lists.hpp"

#include "game/ui/app/title/title_screen.hpp"
#include "game/ui/edit/commands/edit_commands.hpp"
#include "game/ui/edit/edit_parts.hpp"
#include "game/ui/play/commands/play_commands.hpp"
#include "game/ui/play/play_parts.hpp"

namespace trembler::ui {

std::vector<CommandList> commandLists() {
    // A test play in the editor has both kinds.
    CommandList tests = listOf(playCommands());
    CommandList const more = listOf(testCommands());
    tests.commands.insert(tests.commands.end(), more.commands.begin(), more.commands.end());
    return {listOf(playCommands()), listOf(titleCommands()), listOf(editCommands()), tests};
}

std::span<Gesture const> allGestures() {
    return playGestures();
}

} // namespace trembler::ui
