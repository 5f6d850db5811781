#include "game/ui/play/commands/play_commands.hpp"

#include "game/ui/play/commands/command_sections.hpp"

#include <vector>

namespace trembler::ui {
namespace {

std::vector<Command<PlayParts>> joinedSections() {
    std::vector<Command<PlayParts>> table;
    // The page of keys lists the commands in this order.
    for (auto const& section :
         {runCommands(), timelineCommands(), whyCommands(), buildingCommands(), undoingCommands(),
          lookingCommands(), toolCommands(), secondPlayerCommands(), programCommands(), levelCommands()}) {
        table.insert(table.end(), section.begin(), section.end());
    }
    return table;
}

constexpr Gesture gestures[] = {
    {.with = "drag; or click it, then its place", .does = "take a part out of the toolbox"},
    {.with = "drag", .does = "move a part"},
    {.with = "Shift + click", .does = "choose several parts", .beside = "choose-all"},
    {.with = "Shift + drag over the paper", .does = "choose the parts in a box"},
    {.with = "Ctrl, Alt", .does = "hold: place without the grid", .beside = "move-down"},
    {.with = "mouse wheel", .does = "turn the part in hand (Shift: 1°)", .beside = "turn-left"},
    {.with = "drag the knob beside it", .does = "turn the selected part"},
    {.with = "right click", .does = "put a part back, let go", .beside = "put-back"},
    {.with = "drag it onto the toolbox", .does = "put a part back"},
    {.with = "drag", .does = "take hold of an object", .group = CommandGroup::running},
    {.with = "press the scissors, then click the wire", .does = "cut a wire", .group = CommandGroup::running},
    {.with = "click", .does = "show all properties of an object", .group = CommandGroup::looking},
    {.with = "double click",
     .does = "show all properties of a part that you have placed",
     .group = CommandGroup::looking},
    {.with = "click a ring", .does = "show how loud a sound is", .group = CommandGroup::looking},
    {.with = "mouse wheel",
     .does = "zoom; drag the paper to move it",
     .beside = "all-back",
     .group = CommandGroup::looking},
    {.with = "drag with the middle button", .does = "move the paper", .group = CommandGroup::looking},
};

} // namespace

std::span<Command<PlayParts> const> playCommands() {
    static std::vector<Command<PlayParts>> const table = joinedSections();
    return table;
}

std::span<Gesture const> playGestures() {
    return gestures;
}

} // namespace trembler::ui
