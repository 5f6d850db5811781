// A command of the player, given by key or by button: each is one row of a screen's table.
#pragma once

#include "game/ui/shared/commands/chord.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/panels/icons.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace trembler::ui {

enum class KeyUse : std::uint8_t {
    once,    ///< when the key goes down
    repeats, ///< and again while it is held
    held,    ///< the command acts as long as the key is held, see isHeld()
};

/// When the button of a gamepad means a command: the same button may mean another one at another time.
enum class PadPhase : std::uint8_t {
    always,
    building,
    running,
    /// While the past is looked at. A button that then means no available command of this phase means one of
    /// `building` that is available, or else that of `running`.
    past,
    /// While the arrow keys and the directional pad move the view.
    view,
    /// At all times, but only the second player's gamepad gives it; there it comes before other commands of
    /// the same button.
    secondPlayer,
};

/// The section of the page of keys in which a command is listed.
enum class CommandGroup : std::uint8_t { building, running, secondPlayer, looking, program, editing, menus };

/// Name and look of a switch while it is on; nullptr or None: the same as while it is off.
struct WhenOn {
    render::Icon icon = render::Icon::None;
    Phrase name = nullptr;
    Phrase tip = nullptr;
};

/// The public description of a command, independent of the screen that runs it. The texts are stated in
/// British English and read in the player's language.
struct CommandInfo {
    /// The name in profiles; lower-case letters and hyphens. Never changes once published.
    std::string_view id;
    std::array<Chord, 3> keys{}; ///< defaults that the player may replace; tips show the first
    Chord pad{};                 ///< the same for the button of a gamepad
    KeyUse use = KeyUse::once;
    /// It always has a key and a button, if it has them by default: the player can change but not remove
    /// them.
    bool essential = false;
    /// It leads back from a page: its keys act with any modifiers and are nobody else's, the keys pressed
    /// after it in the same picture are ignored, and no list of commands has it.
    bool leads = false;
    render::Icon icon = render::Icon::None;
    CommandGroup group = CommandGroup::program;
    Phrase name = ""; ///< on buttons and in the list of keys
    Phrase tip = "";  ///< one line, without the key
    /// The id of the command whose keys fill the gap "{}" of the tip; "" if it has none. See shownTip().
    std::string_view tipKey{};
    /// Description on the page of keys, as short as possible. Adjacent commands with equal texts share a row.
    Phrase help = "";
    WhenOn whenOn{};
    /// The id of a command whose key has the same effect, for tips; "" if there is none.
    std::string_view alsoBy{};
    PadPhase padPhase = PadPhase::always;
};

/// A row of a screen's table. `Context` is the object that the screen's commands act on.
template <class Context>
struct Command {
    CommandInfo info;
    void (*run)(Context&) = nullptr;
    bool (*available)(Context const&) = nullptr; ///< nullptr: always
    bool (*on)(Context const&) = nullptr;        ///< whether a switch is on; nullptr: not a switch
    /// Why it is not available, for a player who presses its key: a text in the language in use. nullptr, or
    /// one that is returned: for the general reason that its CommandGroup states.
    char const* (*whyNot)(Context const&) = nullptr;
};

/// The commands of one screen, independent of its Context. Indices are rows of its table.
class CommandSet {
public:
    virtual ~CommandSet() = default;
    [[nodiscard]] virtual std::size_t size() const = 0;
    [[nodiscard]] virtual CommandInfo const& info(std::size_t index) const = 0;
    [[nodiscard]] virtual bool available(std::size_t index) const = 0;
    [[nodiscard]] virtual bool on(std::size_t index) const = 0;
    /// Why a command that is not available now is not; nullptr if only its group says it.
    [[nodiscard]] virtual char const* whyNot(std::size_t) const { return nullptr; }
    /// The meaning of the buttons of gamepads at present.
    [[nodiscard]] virtual PadPhase phase() const { return PadPhase::always; }
    /// Does nothing if the command is not available.
    virtual void run(std::size_t index) = 0;

    /// Throws std::invalid_argument if there is no such command, which is a programming error.
    [[nodiscard]] std::size_t indexOf(std::string_view id) const;
    [[nodiscard]] bool has(std::string_view id) const;
    void run(std::string_view id) { run(indexOf(id)); }
};

/// A table with the context on which its commands act.
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
    [[nodiscard]] char const* whyNot(std::size_t index) const override {
        auto* const why = table_[index].whyNot;
        return why == nullptr ? nullptr : why(context_);
    }
    [[nodiscard]] PadPhase phase() const override {
        if constexpr (requires { context_.phase(); }) {
            return context_.phase();
        } else {
            return PadPhase::always;
        }
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
