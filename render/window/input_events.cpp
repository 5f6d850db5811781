#include "render/window/input_events.hpp"

#include <SDL.h>

#include <algorithm>
#include <iterator>
#include <string>

namespace trembler::render {

void InputEvents::poll() {
    events_.clear();
    typed_.clear();
    dropped_.clear();
    for (auto& button : buttons_) {
        button.pressed = button.released = button.twice = false;
    }
    moved_ = {};
    wheel_ = 0;
    modifiersOfFrame_ = 0;
    quitAsked_ = false;
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0) {
        if (event.type == SDL_DROPFILE || event.type == SDL_DROPTEXT) {
            takeDrop(event.drop);
        }
        events_.push_back(event);
        take(event);
        if (pads_ != nullptr) {
            for (SDL_Event const& key : pads_->take(event)) {
                events_.push_back(key);
                take(key);
            }
        }
    }
}

std::vector<SDL_Event> InputEvents::takePadKeys() {
    auto const ofPad = [](SDL_Event const& event) {
        return (event.type == SDL_KEYDOWN || event.type == SDL_KEYUP) && isPadKey(event.key.keysym.sym);
    };
    std::vector<SDL_Event> taken;
    std::copy_if(events_.begin(), events_.end(), std::back_inserter(taken), ofPad);
    std::erase_if(events_, ofPad);
    std::erase_if(heldKeys_, isPadKey);
    return taken;
}

void InputEvents::take(SDL_Event const& event) {
    switch (event.type) {
    case SDL_QUIT:
        quitAsked_ = true;
        break;
    case SDL_MOUSEMOTION:
        moveTo(event.motion.x, event.motion.y);
        break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        takeButton(event.button);
        break;
    case SDL_MOUSEWHEEL: {
        double const turned = static_cast<double>(event.wheel.preciseY);
        wheel_ += event.wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -turned : turned;
        modifiersOfFrame_ |= modifiers_;
        break;
    }
    case SDL_KEYDOWN:
        modifiers_ = event.key.keysym.mod;
        modifiersOfFrame_ |= modifiers_;
        if (!keyHeld(event.key.keysym.sym)) {
            heldKeys_.push_back(event.key.keysym.sym);
        }
        break;
    case SDL_KEYUP:
        modifiers_ = event.key.keysym.mod;
        std::erase(heldKeys_, event.key.keysym.sym);
        break;
    case SDL_WINDOWEVENT:
        takeWindow(event.window);
        break;
    default:
        break;
    }
}

/// The reader of the event owns the text; later readers of the event get none.
void InputEvents::takeDrop(SDL_DropEvent& event) {
    if (event.type == SDL_DROPFILE && event.file != nullptr) {
        std::string const name(event.file);
        dropped_.emplace_back(std::u8string(name.begin(), name.end()));
    }
    SDL_free(event.file);
    event.file = nullptr;
}

void InputEvents::moveTo(int x, int y) {
    double const scale = static_cast<double>(window_.pixelsPerPoint());
    Point const now{x * scale, y * scale};
    if (inside_) {
        moved_ = moved_ + (now - mouse_);
    }
    mouse_ = now;
    inside_ = true;
}

void InputEvents::takeButton(SDL_MouseButtonEvent const& event) {
    moveTo(event.x, event.y);
    modifiersOfFrame_ |= modifiers_;
    std::size_t which = 0;
    switch (event.button) {
    case SDL_BUTTON_LEFT:
        which = index(MouseButton::Left);
        break;
    case SDL_BUTTON_RIGHT:
        which = index(MouseButton::Right);
        break;
    case SDL_BUTTON_MIDDLE:
        which = index(MouseButton::Middle);
        break;
    default:
        return;
    }
    auto& button = buttons_[which];
    if (event.type == SDL_MOUSEBUTTONDOWN) {
        button.held = button.pressed = true;
        button.twice = button.twice || event.clicks == 2;
    } else {
        button.held = false;
        button.released = true;
    }
}

void InputEvents::takeWindow(SDL_WindowEvent const& event) {
    switch (event.event) {
    case SDL_WINDOWEVENT_LEAVE:
        inside_ = false;
        break;
    case SDL_WINDOWEVENT_CLOSE:
        quitAsked_ = true;
        break;
    case SDL_WINDOWEVENT_FOCUS_LOST:
        // Their release will go to another window.
        heldKeys_.clear();
        modifiers_ = modifiersOfFrame_ = 0;
        for (auto& button : buttons_) {
            button.released = button.released || button.held;
            button.held = false;
        }
        break;
    default:
        break;
    }
}

bool InputEvents::keyPressed(SDL_Keycode key, bool repeats) const {
    return std::any_of(events_.begin(), events_.end(), [&](SDL_Event const& event) {
        return event.type == SDL_KEYDOWN && event.key.keysym.sym == key && (repeats || event.key.repeat == 0);
    });
}

bool InputEvents::keyHeld(SDL_Keycode key) const {
    return std::find(heldKeys_.begin(), heldKeys_.end(), key) != heldKeys_.end();
}

bool InputEvents::anyHeld() const {
    return std::any_of(buttons_.begin(), buttons_.end(), [](Button const& button) { return button.held; });
}

} // namespace trembler::render
