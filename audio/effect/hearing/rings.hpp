// For the eye: sounds as faint rings that spread.
#pragma once

#include "audio/effect/properties/sounds.hpp"

#include <span>
#include <vector>

namespace trembler {

/// A ring around where something was struck, as it stands now.
struct SoundRing {
    Vec2 at;             ///< m
    double radius = 0;   ///< m
    double strength = 0; ///< 0 to 1: how dark to draw it
};

/// Collects impacts and lets their rings spread and fade. Sound itself is far too fast to be seen: these
/// walk.
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
    static constexpr double life = 0.8;    ///< s, of the loudest
    static constexpr double faintest = 45; ///< dB(A) at 1 m: softer impacts make none
    static constexpr double loudest = 110; ///< dB(A) at 1 m: from here on a ring is at its darkest
    static constexpr std::size_t mostRings = 64;

private:
    std::vector<SoundRing> rings_;

    std::uint64_t frame_ = 0;
};

} // namespace trembler
