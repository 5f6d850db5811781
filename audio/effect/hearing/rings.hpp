// For the eye: sounds as faint rings that spread.
#pragma once

#include "audio/effect/properties/sounds.hpp"

#include <span>
#include <vector>

namespace trembler {

/// A ring around where something sounds, as it stands now.
struct SoundRing {
    Vec2 at;             ///< m
    double radius = 0;   ///< m
    double strength = 0; ///< 0 to 1: how dark to draw it
    ObjectId from;       ///< what sounds
    ObjectId other;      ///< what it hit; invalid where it only sounds on
};

/// Collects sounds and lets their rings spread and fade. Sound itself is far too fast to be seen: these
/// walk. An impact makes a ring at once; what sounds without one (it rings on, scrapes, plays a recording)
/// makes one every `pulse` seconds, unless a ring of it is still to be seen.
class SoundRings {
public:
    /// Takes over new sounds; a frame that it knows already is not taken twice.
    void hear(Sounds const& sounds);
    /// Lets `duration` (s) pass.
    void advance(double duration);
    /// In the order in which they began. At most mostRings; the faintest give way.
    [[nodiscard]] std::span<SoundRing const> rings() const { return rings_; }
    void clear();

    static constexpr double speed = 1.5;   ///< m/s
    static constexpr double pulse = 0.4;   ///< s, between rings of what sounds on
    static constexpr double life = 0.8;    ///< s, of the loudest
    static constexpr double faintest = 45; ///< dB(A) at 1 m: softer sounds make none
    static constexpr double loudest = 110; ///< dB(A) at 1 m: from here on a ring is at its darkest
    static constexpr std::size_t mostRings = 64;

private:
    void add(SoundRing const& ring);
    void soundOn(ObjectId object, Vec2 at, double meanSquare);

    std::vector<SoundRing> rings_;
    double sincePulse_ = 0;   // s
    std::uint64_t frame_ = 0; // the last that was taken
};

} // namespace trembler
