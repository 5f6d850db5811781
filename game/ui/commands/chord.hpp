// A key with the modifiers that are held with it, and how it is spelt in files and for people.
#pragma once

#include <SDL_keyboard.h>
#include <SDL_keycode.h>

#include <optional>
#include <string>
#include <string_view>

namespace trembler::ui {

/// A key and its modifiers. Plain data; any thread.
struct Chord {
    SDL_Keycode key = SDLK_UNKNOWN; ///< SDLK_UNKNOWN: no key
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

/// What was pressed. Left and right modifiers count alike; Num Lock and Caps Lock are left out.
[[nodiscard]] Chord chordOf(SDL_Keysym const& keysym);
/// Shift, Ctrl, Alt and the like: pressed for another key's sake.
[[nodiscard]] bool isModifier(SDL_Keycode key);

/// "Ctrl+Shift+Z", with SDL's English name of the key: what profiles hold. "" for no key.
[[nodiscard]] std::string nameOf(Chord const& chord);
/// The reverse; upper and lower case count alike. Nothing if it is not a key, or a modifier alone.
[[nodiscard]] std::optional<Chord> chordFrom(std::string_view name);
/// As people read it, and shorter: "Esc", "←". "" for no key.
[[nodiscard]] std::string labelOf(Chord const& chord);

} // namespace trembler::ui
