// Shows sounds as faint rings that spread.
#pragma once

#include "audio/effect/properties/sounds.hpp"

#include <span>
#include <vector>

namespace trembler {

/// The present state of a ring around a source of sound.
struct SoundRing {
    Vec2 at;             ///< m
    double radius = 0;   ///< m
    double strength = 0; ///< 0 to 1: how dark to draw it
    ObjectId from;       ///< the object that sounds
    ObjectId other;      ///< the object that it hit; invalid without an impact
};

/// Collects sounds and makes their rings spread and fade. Rings are much slower than sound, so that they can
/// be seen. An impact makes a ring at once; an object that sounds without an impact (it rings, scrapes, plays
/// a recording) makes one every `pulse` seconds, unless it still has a visible ring.
class SoundRings {
public:
    /// Adds new sounds; a frame that was added before is ignored.
    void hear(Sounds const& sounds);
    /// Advances the rings by `duration` (s).
    void advance(double duration);
    /// In the order in which they began. At most mostRings; beyond, the faintest are removed.
    [[nodiscard]] std::span<SoundRing const> rings() const { return rings_; }
    void clear();

    static constexpr double speed = 1.5;   ///< m/s
    static constexpr double pulse = 0.4;   ///< s, between rings of a continuing sound
    static constexpr double life = 0.8;    ///< s, of the loudest ring
    static constexpr double faintest = 45; ///< dB(A) at 1 m: softer sounds make no ring
    static constexpr double loudest = 110; ///< dB(A) at 1 m: from here on a ring is at its darkest
    static constexpr std::size_t mostRings = 64;

private:
    void add(SoundRing const& ring);
    void soundOn(ObjectId object, Vec2 at, double meanSquare);

    std::vector<SoundRing> rings_;
    double sincePulse_ = 0;   // s
    std::uint64_t frame_ = 0; // the last that was added
};

} // namespace trembler
