// The page of keys and mouse actions: on the screen, and as Markdown for docs/players.md.
#pragma once

#include "game/ui/shared/commands/key_bindings.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace trembler::ui {

/// A mouse action or modifier that has a fixed meaning.
struct Gesture {
    Phrase with = ""; ///< wheel, click, a modifier
    Phrase does = ""; ///< shares a row with a command whose help is the same
    /// Id of the command in whose row or after which the page on the screen lists it; empty: only
    /// docs/players.md does.
    std::string_view beside{};
    CommandGroup group = CommandGroup::building; ///< in docs/players.md
};

struct HelpLine {
    std::string keys; ///< "Q, E"
    std::string does;
};

/// The group's title on the page.
[[nodiscard]] char const* titleOf(CommandGroup group);
/// "C, F3"; "" for none.
[[nodiscard]] std::string labelsOf(std::span<Chord const> keys);

/// A row for every command of the screen that has a key, and for every gesture, in the order of the table.
[[nodiscard]] std::vector<HelpLine> helpLines(CommandSet const& commands, std::span<Gesture const> gestures,
                                              KeyBindings const& bindings);

/// All commands of all screens as Markdown, one table per group: description, current keys, and the id used
/// in profiles.
[[nodiscard]] std::string keysMarkdown(KeyBindings const& bindings);
/// The gestures as Markdown, one table per group.
[[nodiscard]] std::string gesturesMarkdown(std::span<Gesture const> gestures);
/// The same as keysMarkdown() for a terminal.
[[nodiscard]] std::string keysText(KeyBindings const& bindings);
/// The same for programs: {"commands": [{"id", "group", "does", "keys": ["Ctrl+Z"], "held"}]}, with the names
/// of keys that profiles use.
[[nodiscard]] nlohmann::ordered_json keysJson(KeyBindings const& bindings);

} // namespace trembler::ui
