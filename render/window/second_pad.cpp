#include "render/window/second_pad.hpp"

#include <algorithm>

namespace trembler::render {

void SecondPadState::setButtons(SecondPadButtons buttons) {
    if (buttons != buttons_) {
        buttons_ = std::move(buttons);
        letGo();
    }
}

bool SecondPadState::moves(SDL_Keycode key) const {
    auto const has = [&](std::vector<SDL_Keycode> const& keys) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    return has(buttons_.left) || has(buttons_.right) || has(buttons_.up) || has(buttons_.down) ||
           has(buttons_.grab);
}

void SecondPadState::take(PadMotion const& motion) {
    constexpr double atRest = 0.2; // sticks do not come back to their middle exactly
    ways_[{motion.key, motion.axis}] = motion.way < atRest ? 0 : motion.way;
    grabs_ = isPressed(wayOf(buttons_.grab), grabs_);
}

void SecondPadState::letGo() {
    ways_.clear();
    grabs_ = false;
}

double SecondPadState::wayOf(std::vector<SDL_Keycode> const& keys) const {
    double most = 0;
    for (auto const& [button, way] : ways_) {
        if (std::find(keys.begin(), keys.end(), button.first) != keys.end()) {
            most = std::max(most, way);
        }
    }
    return most;
}

SecondPad SecondPadState::now() const {
    return {wayOf(buttons_.right) - wayOf(buttons_.left), wayOf(buttons_.up) - wayOf(buttons_.down), grabs_};
}

} // namespace trembler::render
