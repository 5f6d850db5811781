#include "render/window/synthetic_input.hpp"

#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace trembler::render {

namespace {

void push(SDL_Event event) {
    if (SDL_PushEvent(&event) < 0) {
        throw RenderError(std::string("A synthetic event was not taken: ") + SDL_GetError() + ".");
    }
}

SDL_Event eventFor(Window const& window, SDL_EventType type) {
    SDL_Event event{};
    event.type = type;
    // Keyboard, mouse, wheel and text events all begin with type, time and window.
    event.key.timestamp = SDL_GetTicks();
    event.key.windowID = SDL_GetWindowID(window.handle());
    return event;
}

int inPoints(Window const& window, double pixels) {
    return static_cast<int>(std::lround(pixels / static_cast<double>(window.pixelsPerPoint())));
}

std::uint8_t sdlButton(MouseButton button) {
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

} // namespace

void pushMouseMove(Window const& window, Point at) {
    auto event = eventFor(window, SDL_MOUSEMOTION);
    event.motion.x = inPoints(window, at.x);
    event.motion.y = inPoints(window, at.y);
    push(event);
}

void pushMouseButton(Window const& window, MouseButton button, bool down, Point at, int clicks) {
    auto event = eventFor(window, down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP);
    event.button.button = sdlButton(button);
    event.button.state = down ? SDL_PRESSED : SDL_RELEASED;
    event.button.clicks = static_cast<std::uint8_t>(std::clamp(clicks, 1, 255));
    event.button.x = inPoints(window, at.x);
    event.button.y = inPoints(window, at.y);
    push(event);
}

void pushClick(Window const& window, Point at, MouseButton button) {
    pushMouseMove(window, at);
    pushMouseButton(window, button, true, at);
    pushMouseButton(window, button, false, at);
}

void pushWheel(Window const& window, int notches) {
    auto event = eventFor(window, SDL_MOUSEWHEEL);
    event.wheel.y = notches;
    event.wheel.preciseY = static_cast<float>(notches);
    push(event);
}

void pushKey(Window const& window, SDL_Keycode key, bool down, unsigned modifiers) {
    auto event = eventFor(window, down ? SDL_KEYDOWN : SDL_KEYUP);
    event.key.state = down ? SDL_PRESSED : SDL_RELEASED;
    event.key.keysym.sym = key;
    event.key.keysym.scancode = SDL_GetScancodeFromKey(key);
    event.key.keysym.mod = static_cast<std::uint16_t>(modifiers);
    push(event);
}

void pushText(Window const& window, std::string_view text) {
    while (!text.empty()) {
        auto event = eventFor(window, SDL_TEXTINPUT);
        auto count = std::min(text.size(), sizeof(event.text.text) - 1);
        // An event's text must not end inside of a character.
        while (count < text.size() && count > 1 &&
               (static_cast<unsigned char>(text[count]) & 0xC0U) == 0x80U) {
            --count;
        }
        std::copy_n(text.begin(), count, event.text.text);
        push(event);
        text.remove_prefix(count);
    }
}

void pushDrop(Window const& window, std::filesystem::path const& file) {
    SDL_Event event{};
    event.type = SDL_DROPFILE;
    event.drop.timestamp = SDL_GetTicks();
    event.drop.windowID = SDL_GetWindowID(window.handle());
    auto const name = file.u8string();
    event.drop.file = SDL_strdup(reinterpret_cast<char const*>(name.c_str())); // whoever takes it frees it
    push(event);
}

void pushQuit() {
    SDL_Event event{};
    event.type = SDL_QUIT;
    push(event);
}

} // namespace trembler::render
