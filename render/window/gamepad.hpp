// Gamepads: their buttons arrive as keys, so that a button can do everything that a key can, and can be
// bound.
#pragma once

#include <SDL_events.h>
#include <SDL_gamecontroller.h>
#include <SDL_keycode.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::render {

/// Directions of the left stick count as further buttons behind SDL's: it acts like the directional pad.
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

/// The held buttons and sticks of a second player with a gamepad of their own.
struct SecondPad {
    double x = 0; ///< of the left stick or the directional pad, -1 to 1, to the right
    double y = 0; ///< up
    bool grabs = false;
};

/// Which player the gamepads belong to.
enum class PadUse : std::uint8_t {
    together,    ///< all give keys
    secondApart, ///< the one plugged in second is the second player's
    lastApart,   ///< the last one is, even if it is the only one
};

/// All gamepads that are plugged in, also while the program runs; without any nothing happens. Window thread
/// only; SDL's video part must be running.
class Gamepads {
public:
    Gamepads();
    ~Gamepads();
    Gamepads(Gamepads const&) = delete;
    Gamepads& operator=(Gamepads const&) = delete;

    /// Takes an event of SDL's; returns the key events that it stands for. The left stick gives the keys of
    /// the directional pad: pressed when it passes half of its way, released when it comes back to a third.
    std::vector<SDL_Event> take(SDL_Event const& event);
    [[nodiscard]] std::size_t count() const { return pads_.size(); }
    /// From now on the directions and the button A of the second player's gamepad give no keys.
    void setUse(PadUse use);
    /// The second player's gamepad; nothing if there is none.
    [[nodiscard]] std::optional<SecondPad> second() const;

private:
    void plug(int device);
    void unplug(SDL_JoystickID pad, std::vector<SDL_Event>& events);
    void press(SDL_Keycode key, bool down, std::vector<SDL_Event>& events);
    void moveAxis(SDL_ControllerAxisEvent const& axis, std::vector<SDL_Event>& events);
    [[nodiscard]] bool isSecond(SDL_JoystickID pad) const;
    /// Takes the event if it moves the second player's hand.
    bool takeSecond(SDL_Event const& event, std::vector<SDL_Event>& events);

    bool started_ = false;
    std::map<SDL_JoystickID, SDL_GameController*> pads_;
    std::vector<SDL_Keycode> held_;
    PadUse use_ = PadUse::together;
    std::array<bool, SDL_CONTROLLER_BUTTON_MAX> secondHeld_{};
    double secondX_ = 0; // of the stick, to the right
    double secondY_ = 0; // up
};

} // namespace trembler::render
