#include "render/window/gamepad.hpp"

#include <SDL.h>

#include <algorithm>
#include <iterator>

namespace trembler::render {

Gamepads::Gamepads() : started_(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0) {}

Gamepads::~Gamepads() {
    for (auto const& [id, pad] : pads_) {
        SDL_GameControllerClose(pad);
    }
    if (started_) {
        SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
    }
}

void Gamepads::plug(int device) {
    SDL_GameController* const pad = SDL_GameControllerOpen(device);
    if (pad == nullptr) {
        return;
    }
    SDL_JoystickID const id = SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(pad));
    if (!pads_.emplace(id, pad).second) {
        SDL_GameControllerClose(pad); // it was open already
    }
}

void Gamepads::unplug(SDL_JoystickID id, std::vector<SDL_Event>& events) {
    auto const found = pads_.find(id);
    if (found == pads_.end()) {
        return;
    }
    SDL_GameControllerClose(found->second);
    pads_.erase(found);
    second_.letGo();
    for (auto const& [pad, key] : std::vector(held_)) { // their release will never be reported
        if (pad == id) {
            press(pad, key, false, events);
        }
    }
}

bool Gamepads::anyHolds(SDL_Keycode key) const {
    return std::any_of(held_.begin(), held_.end(), [&](auto const& held) { return held.second == key; });
}

void Gamepads::press(SDL_JoystickID pad, SDL_Keycode key, bool down, std::vector<SDL_Event>& events) {
    bool const before = anyHolds(key);
    std::erase(held_, std::pair(pad, key));
    if (down) {
        held_.emplace_back(pad, key);
    }
    if (before == anyHolds(key)) {
        return;
    }
    SDL_Event event{};
    event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.state = down ? SDL_PRESSED : SDL_RELEASED;
    event.key.timestamp = SDL_GetTicks();
    event.key.keysym.sym = key;
    events.push_back(event);
}

void Gamepads::give(SDL_JoystickID pad, PadMotion const& motion, std::vector<SDL_Event>& events) {
    bool const held = std::find(held_.begin(), held_.end(), std::pair(pad, motion.key)) != held_.end();
    bool const down = isPressed(motion.way, held);
    if (!isSecond(pad) || !second_.moves(motion.key)) {
        press(pad, motion.key, down, events);
        return;
    }
    second_.take(motion);
    if (!down) { // it may have been pressed while the gamepad still gave keys
        press(pad, motion.key, false, events);
    }
}

void Gamepads::setUse(PadUse use) {
    if (use != use_) {
        use_ = use;
        second_.letGo();
    }
}

bool Gamepads::isSecond(SDL_JoystickID pad) const {
    if (use_ == PadUse::together || pads_.empty()) {
        return false;
    }
    if (use_ == PadUse::lastApart) {
        return std::prev(pads_.end())->first == pad;
    }
    return pads_.size() > 1 && std::next(pads_.begin())->first == pad; // by the order of plugging in
}

std::optional<SecondPad> Gamepads::second() const {
    bool const there =
        use_ == PadUse::lastApart ? !pads_.empty() : use_ == PadUse::secondApart && pads_.size() > 1;
    if (!there) {
        return std::nullopt;
    }
    return second_.now();
}

std::vector<SDL_Event> Gamepads::take(SDL_Event const& event) {
    std::vector<SDL_Event> events;
    switch (event.type) {
    case SDL_CONTROLLERDEVICEADDED:
        plug(event.cdevice.which);
        break;
    case SDL_CONTROLLERDEVICEREMOVED:
        unplug(event.cdevice.which, events);
        break;
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
    case SDL_CONTROLLERAXISMOTION: {
        bool const axis = event.type == SDL_CONTROLLERAXISMOTION;
        SDL_JoystickID const pad = axis ? event.caxis.which : event.cbutton.which;
        for (PadMotion const& motion : motionsOf(event)) {
            give(pad, motion, events);
        }
        break;
    }
    default:
        break;
    }
    return events;
}

} // namespace trembler::render
