// A pointer that keys or a gamepad move: it does everything on the field that the mouse does.
#pragma once

#include "game/ui/shared/pointer.hpp"
#include "render/draw/camera.hpp"

namespace trembler::ui {

/// Takes the mouse's place from the first key that moves it until the mouse moves again. One key acts as the
/// button. Window thread only.
class KeyPointer {
public:
    /// Moves it by steps of the grid, or by a fifth of that if `fine`; at first it lies where the mouse is,
    /// or in the middle of the view if the mouse is not on the field.
    void move(Vec2 steps, bool fine, Pointer const& mouse, render::Camera const& camera);
    /// Puts it into use without moving it.
    void show(Pointer const& mouse, render::Camera const& camera) { move({}, false, mouse, camera); }
    /// Moves on while a direction of a gamepad is held, which sends no repeated keys. Call it once per
    /// picture.
    void holdDirection(Vec2 direction, double seconds, bool fine, Pointer const& mouse,
                       render::Camera const& camera);
    /// The pointer of this picture: this one in place of the mouse while it is in use. `held`: the key that
    /// acts as the button is down; `ours`: a key that goes down now is meant for the field, not for a text. A
    /// key that went down before the pointer was in use, or for a text, does nothing until it is pressed
    /// again.
    [[nodiscard]] Pointer instead(Pointer const& mouse, render::Camera const& camera, bool held,
                                  bool ours = true);

    [[nodiscard]] bool active() const { return active_; }
    /// m
    [[nodiscard]] Vec2 at() const { return at_; }

private:
    bool active_ = false;
    bool held_ = false;    // the key acts, in the last picture
    bool keyDown_ = false; // the key, whatever it was meant for
    Vec2 at_;
    double directionHeld_ = 0; // s
};

} // namespace trembler::ui
