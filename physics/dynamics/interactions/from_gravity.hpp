// (Dynamics <- Gravity): the forces of the present model of gravity act at the centres of mass.
#pragma once

#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/gravity/properties.hpp"
#include "runtime/component/interaction.hpp"

namespace trembler {

/// In the thesis it reads Position, too (6.13.4). As addForce acts at the centre of mass anyway, this
/// interaction does not, so that it sleeps while objects move and its held forces do not change. It also
/// reads Fixed, as an object that never moves needs no call, though its mass attracts other objects.
class DynamicsFromGravity final
    : public Interaction<DynamicsFromGravity, DynamicsRole, Reads<GravityForce, Fixed>> {
public:
    static constexpr ComponentText text{.name = "Dynamics <- Gravity",
                                        .effect = "gravity",
                                        .level = "",
                                        .work =
                                            "Applies the force due to gravity to each object at its centre "
                                            "of mass, unless it is fixed, and states how fast it varies."};
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
