// The sections of the level's table of commands: a file with rows for each.
#pragma once

#include "game/ui/play/play_parts.hpp"
#include "game/ui/shared/commands/command.hpp"

#include <cstdint>
#include <span>

namespace trembler::ui {

/// Running, pausing, and how fast.
[[nodiscard]] std::span<Command<PlayParts> const> runCommands();
/// The run that was recorded: looking back, going on from there.
[[nodiscard]] std::span<Command<PlayParts> const> timelineCommands();
[[nodiscard]] std::span<Command<PlayParts> const> whyCommands();
/// Taking, turning, moving and choosing parts, and putting them back.
[[nodiscard]] std::span<Command<PlayParts> const> buildingCommands();
/// Undo, redo, and putting all parts back.
[[nodiscard]] std::span<Command<PlayParts> const> undoingCommands();
/// The camera, the inspector, and the overlays.
[[nodiscard]] std::span<Command<PlayParts> const> lookingCommands();
/// Scissors, hints, the components panel and its time budget.
[[nodiscard]] std::span<Command<PlayParts> const> toolCommands();
/// What the second player's gamepad does, or their keys.
[[nodiscard]] std::span<Command<PlayParts> const> secondPlayerCommands();
/// Films, pictures and solution files; menus and the window.
[[nodiscard]] std::span<Command<PlayParts> const> programCommands();
/// The level as a whole: starting it again, watching a run again, going on to the next one.
[[nodiscard]] std::span<Command<PlayParts> const> levelCommands();

/// The place to go to after the present level: the next one, the gallery that it is the last of, the list of
/// levels (of a level that is none of the program's), the end, if every puzzle is solved, or, of a level that
/// is being edited, the editor.
enum class AfterLevel : std::uint8_t { next, gallery, levels, end, editor };
[[nodiscard]] AfterLevel afterThis(PlayParts const& parts);

/// How far one press of a key moves the view, as a share of the window.
inline constexpr double viewStep = 0.1;

/// For `available` and `on` of several commands: the level runs or is paused.
[[nodiscard]] inline bool inARun(PlayParts const& parts) {
    return !parts.run.building();
}

} // namespace trembler::ui
