#include "render/window/gamepad.hpp"

#include <SDL.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

namespace trembler::render {
namespace {

constexpr int pastHalf = 16384; // of 32767
constexpr int backAtThird = 10922;

struct PadName {
    SDL_Keycode key;
    std::string_view name;
};

constexpr std::array padNames{
    PadName{padKey(SDL_CONTROLLER_BUTTON_A), "Pad A"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_B), "Pad B"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_X), "Pad X"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_Y), "Pad Y"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_BACK), "Pad Back"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_GUIDE), "Pad Guide"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_START), "Pad Start"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_LEFTSTICK), "Pad Left stick"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_RIGHTSTICK), "Pad Right stick"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_LEFTSHOULDER), "Pad L1"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER), "Pad R1"},
    PadName{padLeftTrigger, "Pad L2"},
    PadName{padRightTrigger, "Pad R2"},
    PadName{padRightStickLeft, "Pad RS Left"},
    PadName{padRightStickRight, "Pad RS Right"},
    PadName{padRightStickUp, "Pad RS Up"},
    PadName{padRightStickDown, "Pad RS Down"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_DPAD_UP), "Pad Up"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_DPAD_DOWN), "Pad Down"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_DPAD_LEFT), "Pad Left"},
    PadName{padKey(SDL_CONTROLLER_BUTTON_DPAD_RIGHT), "Pad Right"},
};

} // namespace

std::string_view nameOfPadKey(SDL_Keycode key) {
    auto const found = std::find_if(padNames.begin(), padNames.end(),
                                    [&](PadName const& known) { return known.key == key; });
    return found == padNames.end() ? std::string_view() : found->name;
}

std::optional<SDL_Keycode> padKeyFrom(std::string_view name) {
    auto const same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    auto const found = std::find_if(padNames.begin(), padNames.end(), [&](PadName const& known) {
        return std::equal(known.name.begin(), known.name.end(), name.begin(), name.end(), same);
    });
    return found == padNames.end() ? std::nullopt : std::optional(found->key);
}

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
    secondHeld_ = {};
    secondX_ = secondY_ = 0;
    for (SDL_Keycode const key : std::vector<SDL_Keycode>(held_)) { // their release will never be reported
        press(key, false, events);
    }
}

void Gamepads::press(SDL_Keycode key, bool down, std::vector<SDL_Event>& events) {
    bool const held = std::find(held_.begin(), held_.end(), key) != held_.end();
    if (held == down) {
        return;
    }
    if (down) {
        held_.push_back(key);
    } else {
        std::erase(held_, key);
    }
    SDL_Event event{};
    event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.state = down ? SDL_PRESSED : SDL_RELEASED;
    event.key.timestamp = SDL_GetTicks();
    event.key.keysym.sym = key;
    events.push_back(event);
}

void Gamepads::moveAxis(SDL_ControllerAxisEvent const& axis, std::vector<SDL_Event>& events) {
    auto const direction = [&](SDL_Keycode key, int value) {
        bool const held = std::find(held_.begin(), held_.end(), key) != held_.end();
        press(key, value > (held ? backAtThird : pastHalf), events);
    };
    switch (axis.axis) {
    case SDL_CONTROLLER_AXIS_LEFTX:
        direction(padKey(SDL_CONTROLLER_BUTTON_DPAD_LEFT), -axis.value);
        direction(padKey(SDL_CONTROLLER_BUTTON_DPAD_RIGHT), axis.value);
        break;
    case SDL_CONTROLLER_AXIS_LEFTY:
        direction(padKey(SDL_CONTROLLER_BUTTON_DPAD_UP), -axis.value);
        direction(padKey(SDL_CONTROLLER_BUTTON_DPAD_DOWN), axis.value);
        break;
    case SDL_CONTROLLER_AXIS_RIGHTX:
        direction(padRightStickLeft, -axis.value);
        direction(padRightStickRight, axis.value);
        break;
    case SDL_CONTROLLER_AXIS_RIGHTY:
        direction(padRightStickUp, -axis.value);
        direction(padRightStickDown, axis.value);
        break;
    case SDL_CONTROLLER_AXIS_TRIGGERLEFT:
        direction(padLeftTrigger, axis.value);
        break;
    case SDL_CONTROLLER_AXIS_TRIGGERRIGHT:
        direction(padRightTrigger, axis.value);
        break;
    default:
        break;
    }
}

void Gamepads::setUse(PadUse use) {
    if (use != use_) {
        use_ = use;
        secondHeld_ = {};
        secondX_ = secondY_ = 0;
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
    auto const held = [&](SDL_GameControllerButton button) {
        return secondHeld_[static_cast<std::size_t>(button)] ? 1.0 : 0.0;
    };
    double const x = held(SDL_CONTROLLER_BUTTON_DPAD_RIGHT) - held(SDL_CONTROLLER_BUTTON_DPAD_LEFT);
    double const y = held(SDL_CONTROLLER_BUTTON_DPAD_UP) - held(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    return SecondPad{std::clamp(x + secondX_, -1.0, 1.0), std::clamp(y + secondY_, -1.0, 1.0),
                     held(SDL_CONTROLLER_BUTTON_A) > 0};
}

bool Gamepads::takeSecond(SDL_Event const& event, std::vector<SDL_Event>& events) {
    if (event.type == SDL_CONTROLLERAXISMOTION && isSecond(event.caxis.which)) {
        constexpr double atRest = 0.2; // sticks do not come back to their middle exactly
        double const way = event.caxis.value / 32767.0;
        double const value = std::abs(way) < atRest ? 0 : way;
        if (event.caxis.axis == SDL_CONTROLLER_AXIS_LEFTX) {
            secondX_ = value;
        } else if (event.caxis.axis == SDL_CONTROLLER_AXIS_LEFTY) {
            secondY_ = -value;
        } else {
            return false;
        }
        return true;
    }
    bool const button = event.type == SDL_CONTROLLERBUTTONDOWN || event.type == SDL_CONTROLLERBUTTONUP;
    if (!button || !isSecond(event.cbutton.which)) {
        return false;
    }
    switch (event.cbutton.button) {
    case SDL_CONTROLLER_BUTTON_A:
    case SDL_CONTROLLER_BUTTON_DPAD_UP:
    case SDL_CONTROLLER_BUTTON_DPAD_DOWN:
    case SDL_CONTROLLER_BUTTON_DPAD_LEFT:
    case SDL_CONTROLLER_BUTTON_DPAD_RIGHT:
        break;
    default:
        return false;
    }
    bool const down = event.type == SDL_CONTROLLERBUTTONDOWN;
    secondHeld_[event.cbutton.button] = down;
    if (!down) { // the button may have been pressed while the gamepad still gave keys
        press(padKey(static_cast<SDL_GameControllerButton>(event.cbutton.button)), false, events);
    }
    return true;
}

std::vector<SDL_Event> Gamepads::take(SDL_Event const& event) {
    std::vector<SDL_Event> events;
    if (takeSecond(event, events)) {
        return events;
    }
    switch (event.type) {
    case SDL_CONTROLLERDEVICEADDED:
        plug(event.cdevice.which);
        break;
    case SDL_CONTROLLERDEVICEREMOVED:
        unplug(event.cdevice.which, events);
        break;
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
        press(padKey(static_cast<SDL_GameControllerButton>(event.cbutton.button)),
              event.type == SDL_CONTROLLERBUTTONDOWN, events);
        break;
    case SDL_CONTROLLERAXISMOTION:
        moveAxis(event.caxis, events);
        break;
    default:
        break;
    }
    return events;
}

} // namespace trembler::render
