// The gamepad of a second player, which moves a hand of its own.
#pragma once

#include "render/window/pad_keys.hpp"

#include <map>
#include <utility>
#include <vector>

namespace trembler::render {

/// What the second player wants their hand to do.
struct SecondPad {
    double x = 0; ///< to the right, -1 to 1
    double y = 0; ///< up
    bool grabs = false;
};

/// The buttons of the second player's gamepad that move the hand, as keys of gamepads. All others mean what
/// they mean on every gamepad.
struct SecondPadButtons {
    std::vector<SDL_Keycode> left{padKey(SDL_CONTROLLER_BUTTON_DPAD_LEFT)};
    std::vector<SDL_Keycode> right{padKey(SDL_CONTROLLER_BUTTON_DPAD_RIGHT)};
    std::vector<SDL_Keycode> up{padKey(SDL_CONTROLLER_BUTTON_DPAD_UP)};
    std::vector<SDL_Keycode> down{padKey(SDL_CONTROLLER_BUTTON_DPAD_DOWN)};
    std::vector<SDL_Keycode> grab{padKey(SDL_CONTROLLER_BUTTON_A)};

    friend bool operator==(SecondPadButtons const&, SecondPadButtons const&) = default;
};

/// How far these buttons and sticks are pressed at present.
class SecondPadState {
public:
    /// Other buttons than before are let go.
    void setButtons(SecondPadButtons buttons);
    /// Whether a button moves the hand.
    [[nodiscard]] bool moves(SDL_Keycode key) const;
    /// `motion`: of such a button.
    void take(PadMotion const& motion);
    void letGo();
    [[nodiscard]] SecondPad now() const;

private:
    /// The farthest of the buttons.
    [[nodiscard]] double wayOf(std::vector<SDL_Keycode> const& keys) const;

    SecondPadButtons buttons_;
    /// By key, and whether it is a stick that presses it: the directional pad and the left stick have the
    /// same keys, and letting go of one does not let go of the other.
    std::map<std::pair<SDL_Keycode, bool>, double> ways_;
    bool grabs_ = false;
};

} // namespace trembler::render
