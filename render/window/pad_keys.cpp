#include "render/window/pad_keys.hpp"

#include "runtime/file/lower_case.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace trembler::render {
namespace {

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

std::vector<PadMotion> motionsOfAxis(SDL_ControllerAxisEvent const& axis) {
    double const value = std::clamp(axis.value / 32767.0, -1.0, 1.0);
    auto const directions = [&](SDL_Keycode low, SDL_Keycode high) {
        return std::vector<PadMotion>{{low, std::max(-value, 0.0), true}, {high, std::max(value, 0.0), true}};
    };
    switch (axis.axis) {
    case SDL_CONTROLLER_AXIS_LEFTX:
        return directions(padKey(SDL_CONTROLLER_BUTTON_DPAD_LEFT), padKey(SDL_CONTROLLER_BUTTON_DPAD_RIGHT));
    case SDL_CONTROLLER_AXIS_LEFTY:
        return directions(padKey(SDL_CONTROLLER_BUTTON_DPAD_UP), padKey(SDL_CONTROLLER_BUTTON_DPAD_DOWN));
    case SDL_CONTROLLER_AXIS_RIGHTX:
        return directions(padRightStickLeft, padRightStickRight);
    case SDL_CONTROLLER_AXIS_RIGHTY:
        return directions(padRightStickUp, padRightStickDown);
    case SDL_CONTROLLER_AXIS_TRIGGERLEFT:
        return {{padLeftTrigger, std::max(value, 0.0), true}};
    case SDL_CONTROLLER_AXIS_TRIGGERRIGHT:
        return {{padRightTrigger, std::max(value, 0.0), true}};
    default:
        return {};
    }
}

} // namespace

std::string_view nameOfPadKey(SDL_Keycode key) {
    auto const found = std::find_if(padNames.begin(), padNames.end(),
                                    [&](PadName const& known) { return known.key == key; });
    return found == padNames.end() ? std::string_view() : found->name;
}

std::optional<SDL_Keycode> padKeyFrom(std::string_view name) {
    std::string const wanted = inLowerCase(name);
    auto const found = std::find_if(padNames.begin(), padNames.end(),
                                    [&](PadName const& known) { return inLowerCase(known.name) == wanted; });
    return found == padNames.end() ? std::nullopt : std::optional(found->key);
}

std::vector<PadMotion> motionsOf(SDL_Event const& event) {
    switch (event.type) {
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
        return {{padKey(static_cast<SDL_GameControllerButton>(event.cbutton.button)),
                 event.type == SDL_CONTROLLERBUTTONDOWN ? 1.0 : 0.0, false}};
    case SDL_CONTROLLERAXISMOTION:
        return motionsOfAxis(event.caxis);
    default:
        return {};
    }
}

} // namespace trembler::render
