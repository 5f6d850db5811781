// The buttons, triggers and directions of gamepads as keys, so that a button can do everything that a key
// can, and can be bound.
#pragma once

#include <SDL_events.h>
#include <SDL_gamecontroller.h>
#include <SDL_keycode.h>

#include <optional>
#include <string_view>
#include <vector>

namespace trembler::render {

/// Triggers and directions of the right stick count as further buttons behind SDL's. The left stick has no
/// keys of its own: it acts like the directional pad.
inline constexpr SDL_Keycode firstPadKey = 1 << 28; // SDL's own keys are below, or have bit 30 set

/// The key that stands for a button of any gamepad.
[[nodiscard]] constexpr SDL_Keycode padKey(SDL_GameControllerButton button) {
    return firstPadKey + static_cast<SDL_Keycode>(button);
}
/// The keys of the two triggers, which SDL counts as axes.
inline constexpr SDL_Keycode padLeftTrigger = firstPadKey + SDL_CONTROLLER_BUTTON_MAX;
inline constexpr SDL_Keycode padRightTrigger = padLeftTrigger + 1;
/// The keys of the directions of the right stick.
inline constexpr SDL_Keycode padRightStickLeft = padRightTrigger + 1;
inline constexpr SDL_Keycode padRightStickRight = padRightTrigger + 2;
inline constexpr SDL_Keycode padRightStickUp = padRightTrigger + 3;
inline constexpr SDL_Keycode padRightStickDown = padRightTrigger + 4;
[[nodiscard]] constexpr bool isPadKey(SDL_Keycode key) {
    return key >= firstPadKey && key <= padRightStickDown;
}

/// "Pad A": the name of such a key, in profiles and on the screen; "" for other keys.
[[nodiscard]] std::string_view nameOfPadKey(SDL_Keycode key);
/// The inverse, ignoring case.
[[nodiscard]] std::optional<SDL_Keycode> padKeyFrom(std::string_view name);

/// How far the button or direction of a key is pressed.
struct PadMotion {
    SDL_Keycode key = SDLK_UNKNOWN;
    double way = 0;    ///< 0 to 1
    bool axis = false; ///< by a stick or a trigger
};

/// What an event of a gamepad says about its keys: one for a button, both directions for a stick; nothing for
/// other events.
[[nodiscard]] std::vector<PadMotion> motionsOf(SDL_Event const& event);

/// Whether a button or direction that moved so far is pressed: from half of its way on, and then until it
/// comes back to a third, so that a hand that is not quite still presses it once.
[[nodiscard]] constexpr bool isPressed(double way, bool before) {
    return way > (before ? 1.0 / 3 : 0.5);
}

} // namespace trembler::render
