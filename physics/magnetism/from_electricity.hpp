// (Magnetics <- Electricity): an electromagnet is a magnet while it has electricity.
#pragma once

#include "physics/electricity/properties/electrical.hpp"
#include "physics/magnetism/calls.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/property/for_each.hpp"

namespace trembler {

class MagneticsFromElectricity final
    : public Interaction<MagneticsFromElectricity, MagneticsRole, Reads<ElectricalState, Electromagnet>> {
public:
    static constexpr ComponentText text{
        .name = "Magnetics <- Electricity",
        .effect = "magnetism",
        .level = "",
        .work = "Enables every electromagnet whose electrical state is on and disables every other."};
    using Activation = NeedsAll<Electromagnet>;
    void apply(Access& access) {
        auto const& state = access.read<ElectricalState>();
        forEach(
            [&](ObjectId id, Electromagnet const&) {
                if (state.isOn(id)) {
                    access.call(EnableMagnet{id}, state.eventOf(id));
                } else {
                    access.call(DisableMagnet{id}, state.eventOf(id));
                }
            },
            access.read<Electromagnet>());
    }
};

} // namespace trembler
