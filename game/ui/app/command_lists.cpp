#include "game/ui/app/command_lists.hpp"

#include "game/ui/app/title/title_screen.hpp"
#include "game/ui/edit/commands/edit_commands.hpp"
#include "game/ui/edit/edit_parts.hpp"
#include "game/ui/play/commands/play_commands.hpp"
#include "game/ui/play/play_parts.hpp"
#include "game/ui/shared/commands/menu_keys.hpp"

namespace trembler::ui {

std::vector<CommandList> commandLists() {
    // A test play in the editor has both kinds.
    CommandList tests = listOf(playCommands());
    CommandList const more = listOf(testCommands());
    tests.commands.insert(tests.commands.end(), more.commands.begin(), more.commands.end());
    // The title is a page of buttons, and every such page knows the command for the full screen, too.
    CommandList title = listOf(titleCommands());
    CommandList const pages = menuCommands();
    title.commands.insert(title.commands.end(), pages.commands.begin(), pages.commands.end());
    return {listOf(playCommands()), listOf(editCommands()), tests, title, letterCommands()};
}

std::span<Gesture const> allGestures() {
    return playGestures();
}

} // namespace trembler::ui
