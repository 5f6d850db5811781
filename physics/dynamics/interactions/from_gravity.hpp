// (Dynamics <- Gravity): whatever model of gravity is at work, its forces act at the centres of mass.
#pragma once

#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/gravity/properties.hpp"
#include "runtime/component/interaction.hpp"

namespace trembler {

/// The thesis has it read Position, too (6.13.4); addForce acts at the centre of mass by itself, so reading
/// less lets it sleep while things move: its held forces stay as they are. It also reads Fixed, as an object
/// that never moves needs no call, though it has a mass and attracts like everything else.
class DynamicsFromGravity final
    : public Interaction<DynamicsFromGravity, DynamicsRole, Reads<GravityForce, Fixed>> {
public:
    static constexpr ComponentText text{
        .name = "Dynamics <- Gravity",
        .effect = "gravity",
        .level = "",
        .work =
            "Applies the force due to gravity to each object at its centre of mass, unless it is fixed, and "
            "says how fast it varies."};
    using Activation = NeedsAll<>;
    void apply(Access& access) {
        auto const& forces = access.read<GravityForce>().forces;
        auto const& fixed = access.read<Fixed>();
        access.forChunks(forces.size(), [&](Caller& caller, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (fixed.has(forces[i].object)) {
                    continue;
                }
                caller.call(AddForce{forces[i].object, forces[i].force});
                if (forces[i].rate > 0) {
                    caller.call(StateRate{forces[i].object, forces[i].rate});
                }
            }
        });
    }
};

} // namespace trembler
