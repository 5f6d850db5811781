#include "audio/effect/hearing/rings.hpp"

#include "audio/effect/properties/decibel.hpp"

#include <algorithm>

namespace trembler {
namespace {

/// 0 to 1: the strength of the ring of a sound in Pa² at 1 m; 0 if it is too soft for a ring.
double strengthOf(double meanSquare) {
    double const above = levelOf(meanSquare) - SoundRings::faintest;
    return std::clamp(above / (SoundRings::loudest - SoundRings::faintest), 0.0, 1.0);
}

} // namespace

void SoundRings::hear(Sounds const& sounds) {
    if (sounds.frame == frame_) {
        return;
    }
    frame_ = sounds.frame;
    for (Sounds::Impact const& impact : sounds.impacts) {
        add({impact.at, 0, strengthOf(impact.meanSquare), impact.object, impact.other});
    }
    if (sincePulse_ < pulse) {
        return;
    }
    sincePulse_ = 0;
    for (Sounds::Body const& body : sounds.bodies) {
        soundOn(body.object, body.at, body.loudness);
    }
    for (Sounds::Recording const& recording : sounds.recordings) {
        soundOn(recording.object, recording.at, recording.loudness);
    }
}

void SoundRings::soundOn(ObjectId object, Vec2 at, double meanSquare) {
    bool const seen = std::any_of(rings_.begin(), rings_.end(), [object](SoundRing const& ring) {
        return ring.from == object || ring.other == object;
    });
    if (!seen) {
        add({at, 0, strengthOf(meanSquare), object, {}});
    }
}

void SoundRings::add(SoundRing const& ring) {
    if (ring.strength <= 0) {
        return;
    }
    // An impact is reported for both bodies: one ring, for the louder one.
    auto const same = std::find_if(rings_.begin(), rings_.end(), [&ring](SoundRing const& other) {
        return other.radius == 0 && other.at == ring.at;
    });
    if (same != rings_.end()) {
        same->strength = std::max(same->strength, ring.strength);
        return;
    }
    if (rings_.size() == mostRings) {
        auto const weakest =
            std::min_element(rings_.begin(), rings_.end(),
                             [](SoundRing const& a, SoundRing const& b) { return a.strength < b.strength; });
        if (weakest->strength >= ring.strength) {
            return;
        }
        rings_.erase(weakest);
    }
    rings_.push_back(ring);
}

void SoundRings::advance(double duration) {
    sincePulse_ += duration;
    for (SoundRing& ring : rings_) {
        ring.radius += speed * duration;
        ring.strength -= duration / life;
    }
    std::erase_if(rings_, [](SoundRing const& ring) { return ring.strength <= 0; });
}

void SoundRings::clear() {
    rings_.clear();
    sincePulse_ = 0;
    frame_ = 0;
}

} // namespace trembler
