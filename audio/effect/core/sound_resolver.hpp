// The Sound resolver: computes which modes ring, and how strongly. The number of modes per body is its detail
// level.
#pragma once

#include "audio/effect/core/sound_level.hpp"
#include "audio/effect/core/sound_work.hpp"
#include "runtime/component/resolver.hpp"

namespace trembler {

/// Registered once for each of soundLevels. It is constructed on demand only: for a component that reads
/// Sounds, because of a sensor, or for a loudspeaker (World::want). It changes no object, so listening
/// changes no state.
class SoundResolver final
    : public Resolver<
          SoundResolver, SoundRole,
          Reads<Shape, MadeOf, Acoustics, Sample, Mass, Fixed, Liquid, Position, Rotation, Velocity>,
          Writes<>, Provides<Sounds>> {
public:
    using Activation = NeedsAny<MadeOf, Acoustics, Sample>;
    static constexpr Coverage memory =
        leftOut("the modes of bodies, computed from their properties; the current sounds are in Sounds");
    static constexpr bool onDemand = true;

    SoundResolver(ComponentInfo const& info, SoundLevel const& level) : Resolver(info), work_(level.modes) {}

    [[nodiscard]] bool restless() const { return goesOn_; }
    void advance(Access& access);

private:
    SoundWork work_;
    SoundCalls calls_; // a member to reuse its memory
    bool goesOn_ = true;
};

} // namespace trembler
