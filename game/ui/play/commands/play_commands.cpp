#include "game/ui/play/commands/play_commands.hpp"

#include "game/ui/play/commands/command_sections.hpp"

#include <vector>

namespace trembler::ui {
namespace {

std::vector<Command<PlayParts>> joinedSections() {
    std::vector<Command<PlayParts>> table;
    // The page of keys lists the commands in this order.
    for (auto const& section : {runCommands(), buildingCommands(), lookingCommands(), toolCommands(),
                                programCommands(), levelCommands()}) {
        table.insert(table.end(), section.begin(), section.end());
    }
    return table;
}

constexpr Gesture gestures[] = {
    {.with = "wheel", .does = "turn the part in hand (Shift: 1°)", .beside = "turn-left"},
    {.with = "Ctrl, Alt", .does = "hold: place without the grid", .beside = "move-down"},
    {.with = "right click", .does = "put a part back, let go", .beside = "put-back"},
    {.with = "wheel", .does = "zoom; drag the paper to move it", .beside = "all-back"},
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
