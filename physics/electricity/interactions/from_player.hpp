// (Electricity <- Player): a wire that the player cuts no longer connects.
#pragma once

#include "physics/electricity/calls.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/input/input_resolver.hpp"

namespace trembler {

/// One cut removes one wire of the level: if the level has several between two objects, the others still
/// connect them, and so does a contact. A cut without a wire has no effect.
class ElectricityFromPlayer final
    : public Interaction<ElectricityFromPlayer, ElectricityRole, Reads<PlayerCommands>> {
public:
    static constexpr ComponentText text{.name = "Electricity <- Player",
                                        .effect = "electricity",
                                        .level = "",
                                        .work = "Removes one wire for every cut that the player made."};
    using Activation = NeedsAll<Conductor>;
    void apply(Access& access) {
        for (PlayerCommands::Cut const& cut : access.read<PlayerCommands>().cuts) {
            access.call(CutWire{cut.a, cut.b}, cut.event);
        }
    }
};

} // namespace trembler
