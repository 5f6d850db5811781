// The keys of pages of buttons, of lists and of the keyboard on the screen: commands like all others, which
// the player may bind to other keys and buttons.
#pragma once

#include "game/ui/shared/commands/key_bindings.hpp"

#include <SDL_events.h>

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace trembler::ui {

/// What a key means on a page, in the order of menuCommands().
enum class MenuKey : std::uint8_t {
    up,
    down,
    left,
    right,
    press,
    back,
    next,       ///< item, in their order
    before,     ///< the item before
    type,       ///< begins to type: into a number that can be dragged, or in the field above a list
    erase,      ///< on the page of keys: takes the keys of a command away, as does `type`
    pageNext,   ///< of a panel
    pageBefore, ///< of a panel
};

/// Commands that have no screen: their rows in the page of keys. The first ones are those of MenuKey.
[[nodiscard]] CommandList menuCommands();
/// The commands that the keyboard on the screen has, for gamepads.
[[nodiscard]] CommandList letterCommands();

/// The keys of one picture as the pages read them. Window thread only.
class MenuKeys {
public:
    struct Press {
        MenuKey key;
        bool repeat; ///< by holding the key
    };
    /// Reads a picture's events. `typing`: a text field has the keyboard; then keys that write something are
    /// the field's, and of the others Esc, Enter, Tab and the arrows have their usual meaning if the player
    /// has given them no other.
    void read(std::span<SDL_Event const> events, KeyBindings const& bindings, bool typing);

    [[nodiscard]] std::span<Press const> presses() const { return presses_; }
    [[nodiscard]] bool pressed(MenuKey key, bool repeats = false) const;

private:
    std::vector<Press> presses_;
};

/// The meaning of a pressed key on a page; nullopt if it has none.
[[nodiscard]] std::optional<MenuKey> menuKeyOf(SDL_Keysym const& pressed, KeyBindings const& bindings);

/// The button that the keyboard on the screen has for an action by default, of the one that the player
/// pressed; 0 if it has no action there.
[[nodiscard]] SDL_Keycode letterButtonOf(SDL_Keycode pad, KeyBindings const& bindings);

/// Events as ImGui's widgets read them, which know no bindings: the arrow keys move among them, Space
/// presses, Enter begins to type, Esc leaves. A key keeps the meaning with which it went down until it comes
/// up. Window thread only.
class WidgetKeys {
public:
    [[nodiscard]] SDL_Event read(SDL_Event event, KeyBindings const& bindings, bool typing);

private:
    std::vector<std::pair<SDL_Keycode, SDL_Keysym>> held_;
};

} // namespace trembler::ui
