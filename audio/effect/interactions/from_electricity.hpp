// (Sound <- Electricity): objects that hum while they are on.
#pragma once

#include "audio/effect/calls.hpp"
#include "audio/effect/properties/acoustics.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/property/for_each.hpp"

namespace trembler {

class SoundFromElectricity final
    : public Interaction<SoundFromElectricity, SoundRole, Reads<ElectricalState, Sample>> {
public:
    static constexpr ComponentText text{
        .name = "Sound <- Electricity",
        .effect = "sound",
        .level = "",
        .work = "Keeps the recording going of every object that has one for when it is on, and is."};
    using Activation = NeedsAll<Sample>;
    void apply(Access& access) {
        auto const& state = access.read<ElectricalState>();
        forEach(
            [&](ObjectId id, Sample const& sample) {
                if (sample.cue == SampleCue::powered && state.isOn(id)) {
                    access.call(HoldSample{id}, state.eventOf(id));
                }
            },
            access.read<Sample>());
    }
};

} // namespace trembler
