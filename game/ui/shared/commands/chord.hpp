// A key with the modifiers that are held with it, or a button of a gamepad, and its names in files and on the
// screen.
#pragma once

#include <SDL_keyboard.h>
#include <SDL_keycode.h>

#include <optional>
#include <string>
#include <string_view>

namespace trembler::ui {

/// A key and its modifiers. Plain data; any thread.
struct Chord {
    SDL_Keycode key = SDLK_UNKNOWN; ///< SDLK_UNKNOWN: no key; for buttons of gamepads see gamepad.hpp
    bool ctrl = false;
    bool shift = false;
    bool alt = false;

    [[nodiscard]] constexpr bool any() const { return key != SDLK_UNKNOWN; }
    friend constexpr bool operator==(Chord const&, Chord const&) = default;
};

[[nodiscard]] constexpr Chord withCtrl(SDL_Keycode key) {
    return {.key = key, .ctrl = true};
}
[[nodiscard]] constexpr Chord withCtrlShift(SDL_Keycode key) {
    return {.key = key, .ctrl = true, .shift = true};
}

/// The chord of a key event. Left and right modifiers count alike; Num Lock and Caps Lock are ignored.
[[nodiscard]] Chord chordOf(SDL_Keysym const& keysym);
/// Whether the key is a modifier: Shift, Ctrl, Alt and the like.
[[nodiscard]] bool isModifier(SDL_Keycode key);

/// The name in profiles: "Ctrl+Shift+Z", with SDL's English name of the key. "" for no key.
[[nodiscard]] std::string nameOf(Chord const& chord);
/// The inverse of nameOf, ignoring case. nullopt if the name is not a key's, or is a modifier's alone.
[[nodiscard]] std::optional<Chord> chordFrom(std::string_view name);
/// The shorter name on the screen: "Esc", "←". "" for no key.
[[nodiscard]] std::string labelOf(Chord const& chord);

} // namespace trembler::ui
