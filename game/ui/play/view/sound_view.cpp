#include "game/ui/play/view/sound_view.hpp"

#include "render/scene/facts/shape_geometry.hpp"

namespace trembler::ui {

void SoundView::beforeStep(World const& world) {
    if (!sounds_ || world.frame() == 0) { // the last world no longer exists, or this one begins
        rings_.clear();
        sounds_ = world.want<Sounds>();
    }
}

void SoundView::afterStep(World const& world) {
    rings_.advance(frameDuration);
    if (Sounds const* const sounds = world.find<Sounds>()) {
        rings_.hear(*sounds);
    }
}

std::vector<render::Ripple> SoundView::ripples() const {
    std::vector<render::Ripple> ripples;
    if (!sounds_) {
        return ripples;
    }
    for (SoundRing const& ring : rings_.rings()) {
        ripples.push_back({render::toPoint(ring.at), ring.radius, ring.strength});
    }
    return ripples;
}

} // namespace trembler::ui
