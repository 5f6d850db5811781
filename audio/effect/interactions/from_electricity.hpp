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
        .work =
            "Repeats the recording of every object that is on and whose recording has the cue \"powered\"."};
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
