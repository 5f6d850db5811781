// The Sound resolver: what rings, and how strongly. The number of modes per body is its detail level.
#pragma once

#include "audio/effect/core/sound_work.hpp"
#include "runtime/component/resolver.hpp"
#include "runtime/world/store.hpp"

namespace trembler {

namespace detail {
template <class Self>
using SoundBase =
    Resolver<Self, SoundRole,
             Reads<Shape, MadeOf, Acoustics, Sample, Mass, Fixed, Liquid, Position, Rotation, Velocity>,
             Writes<>, Provides<Sounds>>;
} // namespace detail

/// `Self` adds `text` and `static constexpr int modes`. Nothing is heard where nobody listens: it is there on
/// demand of a component that reads Sounds, because a sensor calls for that, or of a loudspeaker
/// (World::want). It changes no object, so listening changes no state.
template <class Self>
class SoundResolver : public detail::SoundBase<Self> {
    using Base = detail::SoundBase<Self>;

public:
    using Activation = NeedsAny<MadeOf, Acoustics, Sample>;
    static constexpr Coverage memory =
        leftOut("how bodies sound, from their columns; what does sound is in Sounds");
    using Access = typename Base::Access;
    static constexpr bool onDemand = true;

    [[nodiscard]] bool restless() const { return goesOn_; }

    void advance(Access& access) {
        calls_.clear();
        gather<Strike>(access, calls_.strikes);
        gather<Rub>(access, calls_.rubs);
        gather<PlaySample>(access, calls_.plays);
        gather<HoldSample>(access, calls_.holds);
        SoundColumns const columns{access.template read<Shape>(),     access.template read<MadeOf>(),
                                   access.template read<Acoustics>(), access.template read<Sample>(),
                                   access.template read<Mass>(),      access.template read<Fixed>(),
                                   access.template read<Liquid>(),    access.template read<Position>(),
                                   access.template read<Rotation>(),  access.template read<Velocity>()};
        work_.follow(columns);
        if (calls_.empty() && !SoundWork::goesOn(access.template provided<Sounds>())) {
            goesOn_ = false;
            return; // silence: whoever reads Sounds can go on sleeping
        }
        Sounds& sounds = access.template provide<Sounds>();
        work_.advance(columns, calls_, access.duration(), sounds);
        sounds.frame = access.frame();
        goesOn_ = SoundWork::goesOn(sounds);
    }

private:
    template <class C>
    static void gather(Access& access, std::vector<Told<C>>& into) {
        access.template forCalls<C>([&](C const& call, CallOrigin const& origin) {
            into.push_back({call, origin.cause});
        });
    }

    SoundWork work_{Self::modes};
    SoundCalls calls_; // kept for its memory
    bool goesOn_ = true;
};

/// How many objects there are that can sound.
[[nodiscard]] inline std::size_t soundingObjects(Store const& store) {
    auto const* const madeOf = store.findColumn<MadeOf>();
    return madeOf == nullptr ? 0 : madeOf->size();
}

// The detail levels. Eight modes are what most ears ask for; scenes of very many bodies make do with fewer.

class OneModeSound final : public SoundResolver<OneModeSound> {
public:
    static constexpr int modes = 1;
    static constexpr ComponentText text{
        .name = "Sound, 1 mode",
        .effect = "sound",
        .level = "1-mode",
        .work = "Impacts and scrapes excite the modes of bodies, which die away. One mode per body.",
        .rank = 1};
    static bool suits(Store const& store) { return soundingObjects(store) > 5000; }
};

class FourModeSound final : public SoundResolver<FourModeSound> {
public:
    static constexpr int modes = 4;
    static constexpr ComponentText text{
        .name = "Sound, 4 modes",
        .effect = "sound",
        .level = "4-modes",
        .work = "Impacts and scrapes excite the modes of bodies, which die away. Four modes per body.",
        .rank = 2};
    static bool suits(Store const& store) { return soundingObjects(store) > 1000; }
};

class EightModeSound final : public SoundResolver<EightModeSound> {
public:
    static constexpr int modes = 8;
    static constexpr ComponentText text{
        .name = "Sound, 8 modes",
        .effect = "sound",
        .level = "8-modes",
        .work = "Impacts and scrapes excite the modes of bodies, which die away. Eight modes per body.",
        .rank = 3};
};

class SixteenModeSound final : public SoundResolver<SixteenModeSound> {
public:
    static constexpr int modes = 16;
    static constexpr ComponentText text{
        .name = "Sound, 16 modes",
        .effect = "sound",
        .level = "16-modes",
        .work = "Impacts and scrapes excite the modes of bodies, which die away. Sixteen modes per body.",
        .rank = 4};
};

class ThirtyTwoModeSound final : public SoundResolver<ThirtyTwoModeSound> {
public:
    static constexpr int modes = mostModes;
    static constexpr ComponentText text{
        .name = "Sound, 32 modes",
        .effect = "sound",
        .level = "32-modes",
        .work = "Impacts and scrapes excite the modes of bodies, which die away. Up to 32 modes per body.",
        .rank = 5};
};

} // namespace trembler
