#include "audio/effect/hearing/rings.hpp"

#include "audio/effect/properties/decibel.hpp"

#include <algorithm>

namespace trembler {

void SoundRings::hear(Sounds const& sounds) {
    if (sounds.frame == frame_) {
        return;
    }
    frame_ = sounds.frame;
    for (Sounds::Impact const& impact : sounds.impacts) {
        double const level = levelOf(impact.meanSquare);
        if (level < faintest) {
            continue;
        }
        double const strength = std::min(1.0, (level - faintest) / (loudest - faintest));
        // An impact is reported for both bodies: one ring, for the louder of them.
        auto const same = std::find_if(rings_.begin(), rings_.end(), [&](SoundRing const& ring) {
            return ring.radius == 0 && ring.at == impact.at;
        });
        if (same != rings_.end()) {
            same->strength = std::max(same->strength, strength);
            continue;
        }
        if (rings_.size() == mostRings) {
            auto const weakest =
                std::min_element(rings_.begin(), rings_.end(), [](SoundRing const& a, SoundRing const& b) {
                    return a.strength < b.strength;
                });
            if (weakest->strength >= strength) {
                continue;
            }
            rings_.erase(weakest);
        }
        rings_.push_back({impact.at, 0, strength});
    }
}

void SoundRings::advance(double duration) {
    for (SoundRing& ring : rings_) {
        ring.radius += speed * duration;
        ring.strength -= duration / life;
    }
    std::erase_if(rings_, [](SoundRing const& ring) { return ring.strength <= 0; });
}

void SoundRings::clear() {
    rings_.clear();
    frame_ = 0;
}

} // namespace trembler
