// The player's input since the last frame, from SDL's events alone: real ones and synthetic ones alike.
#pragma once

#include "render/draw/geometry.hpp"
#include "render/window/gamepad.hpp"
#include "render/window/window.hpp"

#include <SDL_events.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace trembler::render {

enum class MouseButton : std::uint8_t { Left, Right, Middle };

/// SDL's events of one frame and the state that follows from all of them so far. Nothing here asks SDL for
/// the real mouse or keyboard: events that a test or a replay pushes count as the player's own. Positions are
/// in the window's pixels from the top left. Thread of the window only.
class InputEvents {
public:
    /// All must outlive this. Without gamepads their buttons are ignored.
    explicit InputEvents(Window const& window) : window_(window) {}
    InputEvents(Window const& window, Gamepads& pads) : window_(window), pads_(&pads) {}

    /// Takes everything that waits in SDL's queue; call it once per frame, before Gui::beginFrame.
    void poll();

    /// The events that the last poll took, in order; each event of a gamepad is followed by its key events.
    [[nodiscard]] std::span<SDL_Event const> events() const { return events_; }

    /// Removes the keys of gamepads from this frame's events and from the held keys, and returns them: no
    /// other reader gets them then. For a keyboard on the screen.
    std::vector<SDL_Event> takePadKeys();
    /// Adds an event of this frame that only the widgets get, as a keyboard on the screen makes them.
    void typeForWidgets(SDL_Event const& event) { typed_.push_back(event); }
    [[nodiscard]] std::span<SDL_Event const> typed() const { return typed_; }

    [[nodiscard]] Point mouse() const { return mouse_; }
    /// The mouse is over the window, or was pressed there and is still held.
    [[nodiscard]] bool mouseInside() const { return inside_ || anyHeld(); }
    /// How far the mouse moved in this frame, pixels.
    [[nodiscard]] Point mouseMoved() const { return moved_; }
    /// Wheel notches of this frame, away from the player positive.
    [[nodiscard]] double wheel() const { return wheel_; }
    [[nodiscard]] bool held(MouseButton button) const { return buttons_[index(button)].held; }
    /// Went down, or up, in this frame; both are true for a click faster than a frame.
    [[nodiscard]] bool pressed(MouseButton button) const { return buttons_[index(button)].pressed; }
    [[nodiscard]] bool released(MouseButton button) const { return buttons_[index(button)].released; }
    /// Went down for the second time within SDL's double click time.
    [[nodiscard]] bool doubleClicked(MouseButton button) const { return buttons_[index(button)].twice; }

    /// A key (SDLK_...) went down in this frame; repeats by holding it count only if asked for.
    [[nodiscard]] bool keyPressed(SDL_Keycode key, bool repeats = false) const;
    [[nodiscard]] bool keyHeld(SDL_Keycode key) const;
    /// KMOD_... bits of the last key event, and those that were held at any key, button or wheel event of
    /// this frame: a slow frame may begin after Ctrl was let go again.
    [[nodiscard]] unsigned modifiers() const { return modifiers_ | modifiersOfFrame_; }

    /// Files that the player dropped onto the window in this frame, in order.
    [[nodiscard]] std::span<std::filesystem::path const> dropped() const { return dropped_; }

    /// In this frame the player closed the window, or the desktop asked the program to end.
    [[nodiscard]] bool quitAsked() const { return quitAsked_; }

private:
    struct Button {
        bool held = false;
        bool pressed = false;
        bool released = false;
        bool twice = false;
    };
    [[nodiscard]] static std::size_t index(MouseButton button) { return static_cast<std::size_t>(button); }
    [[nodiscard]] bool anyHeld() const;
    void take(SDL_Event const& event);
    void takeButton(SDL_MouseButtonEvent const& event);
    void takeWindow(SDL_WindowEvent const& event);
    void takeDrop(SDL_DropEvent& event);
    void moveTo(int x, int y);

    Window const& window_;
    Gamepads* pads_ = nullptr;
    std::vector<SDL_Event> events_;
    std::vector<SDL_Event> typed_;
    std::vector<std::filesystem::path> dropped_;
    std::vector<SDL_Keycode> heldKeys_;
    std::array<Button, 3> buttons_{};
    Point mouse_;
    Point moved_;
    double wheel_ = 0;
    unsigned modifiers_ = 0;
    unsigned modifiersOfFrame_ = 0;
    bool inside_ = false;
    bool quitAsked_ = false;
};

} // namespace trembler::render
