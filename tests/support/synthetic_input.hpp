// Events as if the player had made them: they go the whole way through SDL's queue.
#pragma once

#include "render/draw/geometry.hpp"
#include "render/window/input_events.hpp"

#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>

namespace trembler::render {

namespace synthetic {

inline void push(SDL_Event event) {
    if (SDL_PushEvent(&event) < 0) {
        throw RenderError(std::string("A synthetic event was not taken: ") + SDL_GetError() + ".");
    }
}

inline SDL_Event eventFor(Window const& window, SDL_EventType type) {
    SDL_Event event{};
    event.type = type;
    // Keyboard, mouse, wheel and text events all begin with type, time and window.
    event.key.timestamp = SDL_GetTicks();
    event.key.windowID = SDL_GetWindowID(window.handle());
    return event;
}

inline int inPoints(Window const& window, double pixels) {
    return static_cast<int>(std::lround(pixels / static_cast<double>(window.pixelsPerPoint())));
}

inline std::uint8_t sdlButton(MouseButton button) {
    switch (button) {
    case MouseButton::Right:
        return SDL_BUTTON_RIGHT;
    case MouseButton::Middle:
        return SDL_BUTTON_MIDDLE;
    case MouseButton::Left:
        break;
    }
    return SDL_BUTTON_LEFT;
}

} // namespace synthetic

// Positions are in the window's pixels, from the top left; each call queues events that the next
// InputEvents::poll takes. Thread of the window only. They throw RenderError if SDL's queue is full.

inline void pushMouseMove(Window const& window, Point at) {
    auto event = synthetic::eventFor(window, SDL_MOUSEMOTION);
    event.motion.x = synthetic::inPoints(window, at.x);
    event.motion.y = synthetic::inPoints(window, at.y);
    synthetic::push(event);
}

inline void pushMouseButton(Window const& window, MouseButton button, bool down, Point at, int clicks = 1) {
    auto event = synthetic::eventFor(window, down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP);
    event.button.button = synthetic::sdlButton(button);
    event.button.state = down ? SDL_PRESSED : SDL_RELEASED;
    event.button.clicks = static_cast<std::uint8_t>(std::clamp(clicks, 1, 255));
    event.button.x = synthetic::inPoints(window, at.x);
    event.button.y = synthetic::inPoints(window, at.y);
    synthetic::push(event);
}

/// Move, press and release, all in one frame.
inline void pushClick(Window const& window, Point at, MouseButton button = MouseButton::Left) {
    pushMouseMove(window, at);
    pushMouseButton(window, button, true, at);
    pushMouseButton(window, button, false, at);
}

/// Notches, away from the player positive.
inline void pushWheel(Window const& window, int notches) {
    auto event = synthetic::eventFor(window, SDL_MOUSEWHEEL);
    event.wheel.y = notches;
    event.wheel.preciseY = static_cast<float>(notches);
    synthetic::push(event);
}

inline void pushKey(Window const& window, SDL_Keycode key, bool down, unsigned modifiers = KMOD_NONE) {
    auto event = synthetic::eventFor(window, down ? SDL_KEYDOWN : SDL_KEYUP);
    event.key.state = down ? SDL_PRESSED : SDL_RELEASED;
    event.key.keysym.sym = key;
    event.key.keysym.scancode = SDL_GetScancodeFromKey(key);
    event.key.keysym.mod = static_cast<std::uint16_t>(modifiers);
    synthetic::push(event);
}

/// UTF-8, as typed into a text field.
inline void pushText(Window const& window, std::string_view text) {
    while (!text.empty()) {
        auto event = synthetic::eventFor(window, SDL_TEXTINPUT);
        auto count = std::min(text.size(), sizeof(event.text.text) - 1);
        // An event's text must not end inside of a character.
        while (count < text.size() && count > 1 &&
               (static_cast<unsigned char>(text[count]) & 0xC0U) == 0x80U) {
            --count;
        }
        std::copy_n(text.begin(), count, event.text.text);
        synthetic::push(event);
        text.remove_prefix(count);
    }
}

/// A file that is dropped onto the window.
inline void pushDrop(Window const& window, std::filesystem::path const& file) {
    SDL_Event event{};
    event.type = SDL_DROPFILE;
    event.drop.timestamp = SDL_GetTicks();
    event.drop.windowID = SDL_GetWindowID(window.handle());
    auto const name = file.u8string();
    event.drop.file = SDL_strdup(reinterpret_cast<char const*>(name.c_str())); // InputEvents frees it
    synthetic::push(event);
}

inline void pushQuit() {
    SDL_Event event{};
    event.type = SDL_QUIT;
    synthetic::push(event);
}

} // namespace trembler::render
