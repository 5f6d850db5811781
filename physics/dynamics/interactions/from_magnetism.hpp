// (Dynamics <- Magnetic Forces): magnetic forces act at the poles, or at the centre of an object without
// poles.
#pragma once

#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/component/interaction.hpp"

namespace trembler {

/// F_M contains the points, so this need not read the poles and positions of 6.13.4.
class DynamicsFromMagneticForces final
    : public Interaction<DynamicsFromMagneticForces, DynamicsRole, Reads<MagneticForce, Fixed>> {
public:
    static constexpr ComponentText text{
        .name = "Dynamics <- Magnetic Forces",
        .effect = "magnetism",
        .level = "",
        .work = "Adds all the forces calculated in the Magnetic Forces DPS at the "
                "magnetic poles, or at the centre of an object without poles, and states how fast they vary; "
                "resists the spin of what a magnet pulls, whose magnetisation lags."};
    using Activation = NeedsAll<>;
    void apply(Access& access) {
        auto const& forces = access.read<MagneticForce>().forces;
        auto const& fixed = access.read<Fixed>();
        bool const foreseen = access.read<MagneticForce>().foreseen;
        for (MagneticForce::Rate const& one : access.read<MagneticForce>().rates) {
            access.call(StateRate{one.object, one.rate, foreseen});
        }
        for (MagneticForce::Brake const& brake : access.read<MagneticForce>().brakes) {
            if (!fixed.has(brake.object)) {
                access.call(AddDrag{.object = brake.object, .point = brake.centre, .angular = brake.angular});
            }
        }
        access.forChunks(forces.size(), [&](Caller& caller, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (!fixed.has(forces[i].object)) {
                    caller.call(AddForceToPoint{forces[i].object, forces[i].point, forces[i].force},
                                forces[i].cause);
                }
            }
        });
    }
};

} // namespace trembler
