#include "game/ui/edit/commands/edit_commands.hpp"

#include "game/ui/edit/commands/command_menus.hpp"
#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/edit_parts.hpp"
#include "game/ui/shared/commands/common_commands.hpp"

#include <vector>

namespace trembler::ui {
namespace {

using render::Icon;

constexpr Command<EditParts> unlisted[] = {
    {.info = common::back, .run = actions::back},
    {.info = common::fullscreen, .run = actions::switchFullscreen},
};

constexpr Command<EditParts> whileTesting[] = {
    {.info = {.id = "edit-record",
              .keys = {{withCtrl(SDLK_r)}},
              .icon = Icon::Save,
              .group = CommandGroup::editing,
              .name = "Record solution",
              .tip = "Keep this run as a solution of the level",
              .help = "keep a test run as a solution"},
     .run = actions::recordSolution,
     .available = actions::isTesting},
};

std::vector<Command<EditParts>> joinedMenus() {
    std::vector<Command<EditParts>> table;
    for (EditMenu const& menu : editMenus) {
        auto const section = menu.commands();
        table.insert(table.end(), section.begin(), section.end());
    }
    table.insert(table.end(), std::begin(unlisted), std::end(unlisted));
    return table;
}

constexpr Gesture gesturesOfEditor[] = {
    {.with = "click", .does = "select (Shift: add or remove)", .group = CommandGroup::editing},
    {.with = "double click", .does = "select a piece of a part", .group = CommandGroup::editing},
    {.with = "drag on the paper", .does = "select with a box", .group = CommandGroup::editing},
    {.with = "drag an object", .does = "move the selection", .group = CommandGroup::editing},
    {.with = "drag the round knob", .does = "turn the selection", .group = CommandGroup::editing},
    {.with = "drag a square knob",
     .does = "scale the shape (Shift: keep its proportions)",
     .group = CommandGroup::editing},
    {.with = "drag a corner", .does = "change a polygon", .group = CommandGroup::editing},
    {.with = "right click", .does = "put the tool away: back to Select", .group = CommandGroup::editing},
    {.with = "Ctrl, Alt", .does = "hold: without the grid", .group = CommandGroup::editing},
    {.with = "wheel", .does = "zoom", .group = CommandGroup::editing},
    {.with = "drag with the right or middle button",
     .does = "move the paper",
     .group = CommandGroup::editing},
};

} // namespace

std::span<Command<EditParts> const> editCommands() {
    static std::vector<Command<EditParts>> const table = joinedMenus();
    return table;
}

std::span<Command<EditParts> const> testCommands() {
    return whileTesting;
}

std::span<Gesture const> editGestures() {
    return gesturesOfEditor;
}

} // namespace trembler::ui
