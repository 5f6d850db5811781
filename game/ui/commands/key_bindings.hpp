// Which keys stand for which commands: those of the tables, unless the player has chosen others.
#pragma once

#include "game/ui/commands/command.hpp"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::ui {

/// The commands of one kind of screen, without such a screen. A command of several screens (the same id) has
/// the same keys in all of them.
struct CommandList {
    std::vector<CommandInfo const*> commands;
};

template <class Context>
[[nodiscard]] CommandList listOf(std::span<Command<Context> const> table) {
    CommandList list;
    for (Command<Context> const& command : table) {
        list.commands.push_back(&command.info);
    }
    return list;
}

/// Keys as a profile holds them: names of chords by id of the command.
using StatedKeys = std::map<std::string, std::vector<std::string>>;

/// On one screen no two commands ever have the same chord. Window thread only.
class KeyBindings {
public:
    /// What the lists point to must outlive this, and have no conflicts of its own.
    explicit KeyBindings(std::vector<CommandList> screens);

    /// Takes what differs from the tables. What cannot be taken keeps the keys of its table; returns a
    /// sentence for each such thing.
    [[nodiscard]] std::vector<std::string> load(StatedKeys const& stated);
    /// What differs from the tables, for a profile.
    [[nodiscard]] StatedKeys stated() const;

    /// Of a command of any of the screens, the most important first; empty if it has none.
    [[nodiscard]] std::span<Chord const> keysOf(std::string_view id) const;
    /// All commands once, in the order of the tables.
    [[nodiscard]] std::vector<CommandInfo const*> const& commands() const { return commands_; }
    /// The same, group by group.
    [[nodiscard]] std::vector<CommandInfo const*> inGroups() const;
    [[nodiscard]] bool isDefault() const { return stated().empty(); }

    /// Why the command cannot have this chord, in words for the player; nothing if it can.
    [[nodiscard]] std::optional<std::string> whyNot(CommandInfo const& command, Chord const& chord) const;
    /// Gives the command this chord instead of all that it has; does nothing and returns why if it cannot.
    std::optional<std::string> bind(CommandInfo const& command, Chord const& chord);
    /// Leaves a command without a key; one that is fixed keeps its own.
    void unbind(CommandInfo const& command);
    /// All as in the tables.
    void reset();

    /// The command that pressing a key asks for. A chord with Shift or Alt goes before one without; where
    /// there is none with them they make no difference, as tools give them a meaning of their own. Nothing
    /// for keys of KeyUse::held.
    [[nodiscard]] std::optional<std::size_t> find(CommandSet const& commands,
                                                  SDL_Keysym const& pressed) const;

private:
    /// nullptr: there is no such command.
    [[nodiscard]] CommandInfo const* known(std::string_view id) const;
    [[nodiscard]] bool shareAScreen(CommandInfo const& a, CommandInfo const& b) const;
    [[nodiscard]] CommandInfo const* owner(CommandInfo const& asking, Chord const& chord) const;
    [[nodiscard]] std::optional<std::vector<Chord>> read(CommandInfo const& command,
                                                         std::vector<std::string> const& names,
                                                         std::vector<std::string>& troubles) const;
    void settleConflicts(StatedKeys const& stated, std::vector<std::string>& troubles);

    std::vector<CommandList> screens_;
    std::vector<CommandInfo const*> commands_;
    std::map<std::string_view, std::vector<Chord>> keys_;
};

/// "Undo (Ctrl+Z)": a text with the first key of the command; without a key only the text.
[[nodiscard]] std::string withKey(std::string const& text, std::string_view id, KeyBindings const& bindings);
/// The same of a command's tip, as it is while a switch is on or off.
[[nodiscard]] std::string tipOf(CommandInfo const& command, bool on, KeyBindings const& bindings);

} // namespace trembler::ui
