#include "game/ui/play/run/touch_sounds.hpp"

#include "audio/device/loudspeaker.hpp"

namespace trembler::ui {

std::optional<InterfaceSound> soundBetween(Touched const& before, Touched const& now) {
    if (now.troubles > before.troubles) {
        return InterfaceSound::refuse;
    }
    if (now.solved && !before.solved) {
        return InterfaceSound::solved;
    }
    if (now.building != before.building) {
        return InterfaceSound::run;
    }
    if (now.carrying && !before.carrying) {
        return InterfaceSound::pickUp;
    }
    if (now.building && now.world != before.world) { // built again with another placement
        return InterfaceSound::place;
    }
    return std::nullopt;
}

void TouchSounds::look(Touched const& now) {
    auto const sound = before_ ? soundBetween(*before_, now) : std::nullopt;
    before_ = now;
    if (sound && loudspeaker_ != nullptr) {
        loudspeaker_->touch(*sound);
    }
}

} // namespace trembler::ui
