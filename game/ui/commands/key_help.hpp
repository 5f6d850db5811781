// The page of keys: on the screen, and as Markdown for docs/players.md.
#pragma once

#include "game/ui/commands/key_bindings.hpp"

#include <string>
#include <vector>

namespace trembler::ui {

/// What hands do besides pressing a command's key; it cannot be changed.
struct Gesture {
    char const* with = "";     ///< wheel, click, a modifier
    char const* does = "";     ///< if a command's help says the same, the two share a row
    std::string_view beside{}; ///< id of the command at whose row it stands
};

struct HelpLine {
    std::string keys; ///< "Q, E"
    std::string does;
};

/// What people call it.
[[nodiscard]] char const* titleOf(CommandGroup group);
/// "C, F3"; "" for none.
[[nodiscard]] std::string labelsOf(std::span<Chord const> keys);

/// A row for every command of the screen that has a key, and for every gesture, in the order of the table.
[[nodiscard]] std::vector<HelpLine> helpLines(CommandSet const& commands, std::span<Gesture const> gestures,
                                              KeyBindings const& bindings);

/// All commands of all screens as Markdown, a table for each group: what it does, its keys as bound, and its
/// id for the profile.
[[nodiscard]] std::string keysMarkdown(KeyBindings const& bindings);
/// The same for a terminal.
[[nodiscard]] std::string keysText(KeyBindings const& bindings);

} // namespace trembler::ui
