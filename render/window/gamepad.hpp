// Gamepads: their buttons arrive as keys, see pad_keys.hpp, or move the second player's hand.
#pragma once

#include "render/window/pad_keys.hpp"
#include "render/window/second_pad.hpp"

#include <SDL_events.h>
#include <SDL_gamecontroller.h>

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace trembler::render {

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
    /// From now on the buttons of the second player's gamepad that move the hand give no keys.
    void setUse(PadUse use);
    void setSecondButtons(SecondPadButtons buttons) { second_.setButtons(std::move(buttons)); }
    /// The second player's gamepad; nothing if there is none.
    [[nodiscard]] std::optional<SecondPad> second() const;

private:
    void plug(int device);
    void unplug(SDL_JoystickID pad, std::vector<SDL_Event>& events);
    void press(SDL_JoystickID pad, SDL_Keycode key, bool down, std::vector<SDL_Event>& events);
    void give(SDL_JoystickID pad, PadMotion const& motion, std::vector<SDL_Event>& events);
    [[nodiscard]] bool isSecond(SDL_JoystickID pad) const;
    /// Whether any gamepad holds the key.
    [[nodiscard]] bool anyHolds(SDL_Keycode key) const;

    bool started_ = false;
    std::map<SDL_JoystickID, SDL_GameController*> pads_;
    std::vector<std::pair<SDL_JoystickID, SDL_Keycode>> held_;
    PadUse use_ = PadUse::together;
    SecondPadState second_;
};

} // namespace trembler::render
