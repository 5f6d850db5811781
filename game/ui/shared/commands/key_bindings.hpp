// The keys of all commands: the tables' defaults, unless the player has chosen others.
#pragma once

#include "game/ui/shared/commands/command.hpp"
#include "game/ui/shared/kept/settings.hpp"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::ui {

/// The commands of one kind of screen, without an instance of it. A command that several screens share (the
/// same id) has the same keys in all of them.
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

/// No two commands of one screen ever have the same chord, and essential commands always have one. Window
/// thread only.
class KeyBindings {
public:
    /// The objects that the lists refer to must outlive this, and their default keys must not conflict.
    explicit KeyBindings(std::vector<CommandList> screens);

    /// Applies stored keys. A command whose stored keys are invalid or in conflict keeps its defaults;
    /// returns a sentence for each such problem.
    [[nodiscard]] std::vector<std::string> load(StatedKeys const& stated);
    /// The keys that differ from the defaults, for a profile.
    [[nodiscard]] StatedKeys stated() const;

    /// The chords of a command, the one shown in tips first; empty if it has none.
    [[nodiscard]] std::span<Chord const> keysOf(std::string_view id) const;
    /// All commands of all screens without duplicates, in the order of the tables.
    [[nodiscard]] std::vector<CommandInfo const*> const& commands() const { return commands_; }
    /// The same, sorted by group.
    [[nodiscard]] std::vector<CommandInfo const*> inGroups() const;
    [[nodiscard]] bool isDefault() const { return stated().empty(); }

    /// Why the command cannot have this chord, as a sentence for the player; nullopt if it can.
    [[nodiscard]] std::optional<std::string> whyNot(CommandInfo const& command, Chord const& chord) const;
    /// Replaces all keys of the command by this chord, or by a gamepad's button all its buttons; if that is
    /// not possible, changes nothing and returns the reason.
    std::optional<std::string> bind(CommandInfo const& command, Chord const& chord);
    /// Removes the command's keys; an essential command keeps its own, and the reason is returned.
    std::optional<std::string> unbind(CommandInfo const& command);
    /// Restores all defaults.
    void reset();

    /// The command for a pressed key. A chord with Shift or Alt takes precedence over one without; if no
    /// chord has these modifiers they are ignored, as tools give them other meanings. nullopt for keys of
    /// KeyUse::held.
    [[nodiscard]] std::optional<std::size_t> find(CommandSet const& commands,
                                                  SDL_Keysym const& pressed) const;

private:
    /// The command with this id, or nullptr.
    [[nodiscard]] CommandInfo const* known(std::string_view id) const;
    [[nodiscard]] bool shareAScreen(CommandInfo const& a, CommandInfo const& b) const;
    [[nodiscard]] CommandInfo const* owner(CommandInfo const& asking, Chord const& chord) const;
    /// Whether an essential command has no key or no button any more.
    [[nodiscard]] bool lacksKeys(CommandInfo const& command) const;
    [[nodiscard]] std::optional<std::vector<Chord>> read(CommandInfo const& command,
                                                         std::vector<std::string> const& names,
                                                         std::vector<std::string>& troubles) const;
    void settleConflicts(StatedKeys const& stated, std::vector<std::string>& troubles);

    std::vector<CommandList> screens_;
    std::vector<CommandInfo const*> commands_;
    std::map<std::string_view, std::vector<Chord>> keys_;
};

/// "Undo (Ctrl+Z)": the text with the first key of the command; the text alone if it has no key.
[[nodiscard]] std::string withKey(std::string const& text, std::string_view id, KeyBindings const& bindings);

} // namespace trembler::ui
