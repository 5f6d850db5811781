#include "game/ui/play/run/level_audio.hpp"

#include "audio/device/loudspeaker.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

// The listener is as far from the plane of the world as the visible part of that is high, so that objects
// sound near when they look large.
Listener listenerOf(render::Camera const& camera) {
    double const seen = camera.viewport.height / camera.pixelsPerMetre;
    return {.at = {camera.centre.x, camera.centre.y}, .height = std::clamp(seen, 0.5, 50.0), .velocity = {}};
}

} // namespace

void LevelAudio::enter(World const& world) {
    if (loudspeaker_ != nullptr) {
        loudspeaker_->enter(world);
        clock_.reset();
    }
}

void LevelAudio::leave() {
    if (loudspeaker_ != nullptr) {
        loudspeaker_->leave();
    }
}

void LevelAudio::frame(World const& world, render::Camera const& camera) {
    if (loudspeaker_ != nullptr) {
        loudspeaker_->frame(world, listenerOf(camera));
    }
}

void LevelAudio::pause(double seconds, render::Camera const& camera) {
    if (loudspeaker_ != nullptr) {
        for (int due = clock_.due(seconds); due > 0; --due) {
            loudspeaker_->pause(listenerOf(camera));
        }
    }
}

} // namespace trembler::ui
