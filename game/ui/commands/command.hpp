// What a player can ask for, by key or by button: one row of a table for each command.
#pragma once

#include "game/ui/commands/chord.hpp"
#include "render/panels/icons.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace trembler::ui {

enum class KeyUse : std::uint8_t {
    once,    ///< when the key goes down
    repeats, ///< and again while it is held
    held,    ///< the key is no switch: it counts as long as it is held, see KeyBindings::held()
};

/// Where a command stands on the page of keys.
enum class CommandGroup : std::uint8_t { building, running, looking, program };

/// How a command that is a switch looks and reads while it is on; nullptr or None: as while it is off.
struct WhenOn {
    render::Icon icon = render::Icon::None;
    char const* name = nullptr;
    char const* tip = nullptr;
};

/// What everybody may know of a command without the screen that carries it out. The words are in British
/// English and live for ever.
struct CommandInfo {
    /// What it is called in profiles; small letters and hyphens. Never changes once published.
    std::string_view id;
    std::array<Chord, 2> keys{}; ///< unless the player has others; the first is the one that tips name
    KeyUse use = KeyUse::once;
    bool fixed = false; ///< the player cannot give it other keys; modifiers make no difference
    render::Icon icon = render::Icon::None;
    CommandGroup group = CommandGroup::program;
    char const* name = ""; ///< on buttons and in the list of keys
    char const* tip = "";  ///< a line, without the key
    /// On the page of keys, as short as can be. Neighbours with equal words share a row.
    char const* help = "";
    WhenOn whenOn{};
    /// The id of the command whose key does this too, for tips; "" if there is none.
    std::string_view alsoBy{};
};

/// A row of a screen's table. `Context` is what the screen is made of.
template <class Context>
struct Command {
    CommandInfo info;
    void (*run)(Context&) = nullptr;
    bool (*available)(Context const&) = nullptr; ///< nullptr: always
    bool (*on)(Context const&) = nullptr;        ///< of a switch; nullptr: it is none
};

/// The commands of one screen, whatever it is made of. Indices are places in its table.
class CommandSet {
public:
    virtual ~CommandSet() = default;
    [[nodiscard]] virtual std::size_t size() const = 0;
    [[nodiscard]] virtual CommandInfo const& info(std::size_t index) const = 0;
    [[nodiscard]] virtual bool available(std::size_t index) const = 0;
    [[nodiscard]] virtual bool on(std::size_t index) const = 0;
    /// Does nothing if it is not available.
    virtual void run(std::size_t index) = 0;

    /// Throws std::invalid_argument if there is no such command: a mistake in the program.
    [[nodiscard]] std::size_t indexOf(std::string_view id) const;
    [[nodiscard]] bool has(std::string_view id) const;
    void run(std::string_view id) { run(indexOf(id)); }
};

/// A table and what it works on.
template <class Context>
class CommandsOf final : public CommandSet {
public:
    using CommandSet::run;

    /// Both must outlive this.
    CommandsOf(std::span<Command<Context> const> table, Context& context)
        : table_(table), context_(context) {}

    [[nodiscard]] std::size_t size() const override { return table_.size(); }
    [[nodiscard]] CommandInfo const& info(std::size_t index) const override { return table_[index].info; }
    [[nodiscard]] bool available(std::size_t index) const override {
        auto* const available = table_[index].available;
        return available == nullptr || available(context_);
    }
    [[nodiscard]] bool on(std::size_t index) const override {
        auto* const on = table_[index].on;
        return on != nullptr && on(context_);
    }
    void run(std::size_t index) override {
        if (available(index)) {
            table_[index].run(context_);
        }
    }

private:
    std::span<Command<Context> const> table_;
    Context& context_;
};

} // namespace trembler::ui
