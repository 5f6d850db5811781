// A gamepad of SDL's that exists only in the program.
#pragma once

#include "tests/game/ui/player.hpp"

#include <SDL_gamecontroller.h>
#include <SDL_joystick.h>

#include <algorithm>

namespace trembler::ui::test {

/// A gamepad that is plugged in while the program runs.
class VirtualPad {
public:
    VirtualPad()
        : device_(SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                            SDL_CONTROLLER_BUTTON_MAX, 0)) {
        joystick_ = device_ < 0 ? nullptr : SDL_JoystickOpen(device_);
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1"); // no window has the focus here
    }
    ~VirtualPad() {
        SDL_JoystickClose(joystick_);
        SDL_JoystickDetachVirtual(device_);
    }
    VirtualPad(VirtualPad const&) = delete;
    VirtualPad& operator=(VirtualPad const&) = delete;

    [[nodiscard]] bool works() const {
        return joystick_ != nullptr && SDL_IsGameController(device_) == SDL_TRUE;
    }
    void hold(Player& player, SDL_GameControllerButton button, bool down) const {
        SDL_JoystickSetVirtualButton(joystick_, button, down ? SDL_PRESSED : SDL_RELEASED);
        SDL_JoystickUpdate();
        player.frames(1);
    }
    /// The axis stays where it is set.
    void lean(Player& player, SDL_GameControllerAxis axis, Sint16 value) const {
        SDL_JoystickSetVirtualAxis(joystick_, axis, value);
        SDL_JoystickUpdate();
        player.frames(1);
    }
    void press(Player& player, SDL_GameControllerButton button) const {
        for (Uint8 const state : {Uint8{SDL_PRESSED}, Uint8{SDL_RELEASED}}) {
            SDL_JoystickSetVirtualButton(joystick_, button, state);
            SDL_JoystickUpdate();
            player.frames(2);
        }
    }
    void push(Player& player, SDL_GameControllerAxis axis, Sint16 value) const {
        for (Sint16 const way : {value, Sint16{0}}) {
            SDL_JoystickSetVirtualAxis(joystick_, axis, way);
            SDL_JoystickUpdate();
            player.frames(2);
        }
    }
    /// Leans the stick until the second pointer is at a place, or for a while.
    void leadSecondPointer(Player& player, Vec2 to) const {
        auto const at = [&] { return player.play().secondPointer().at(); };
        for (int i = 0; i < 300 && length(at() - to) > 0.035; ++i) {
            Vec2 const way = to - at();
            double const far = std::max(length(way), 0.1); // slower near the place
            lean(player, SDL_CONTROLLER_AXIS_LEFTX, static_cast<Sint16>(32000 * way.x / far));
            lean(player, SDL_CONTROLLER_AXIS_LEFTY, static_cast<Sint16>(-32000 * way.y / far));
        }
        lean(player, SDL_CONTROLLER_AXIS_LEFTX, 0);
        lean(player, SDL_CONTROLLER_AXIS_LEFTY, 0);
    }

private:
    int device_;
    SDL_Joystick* joystick_ = nullptr;
};

} // namespace trembler::ui::test
