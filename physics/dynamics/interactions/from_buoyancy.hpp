// (Dynamics <- Buoyancy): F_B acts at the centre of buoyancy.
#pragma once

#include "physics/buoyancy/properties/results.hpp"
#include "physics/dynamics/calls.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/placement.hpp"

namespace trembler {

/// In addition to the properties that the thesis lists (6.11.4) it reads the object's place: with a period,
/// F_B and its centre in the object's frame stay constant while the object, and with it the point of the
/// force, moves.
///
/// It reports no rate: Liquid Drag derives the rate of F_B together with the resistance that looks ahead for
/// it, and (Dynamics <- Liquid Drag) reports it with that resistance. Whether F_B is foreseen depends on it.
class DynamicsFromBuoyancy final
    : public Interaction<DynamicsFromBuoyancy, DynamicsRole,
                         Reads<BuoyancyForce, CentreOfBuoyancy, Position, Rotation>> {
public:
    static constexpr ComponentText text{.name = "Dynamics <- Buoyancy",
                                        .effect = "buoyancy",
                                        .level = "",
                                        .work = "Applies F_B to each object at its centre of buoyancy."};
    using Activation = NeedsAll<>;
    void apply(Access& access) {
        auto const& forces = access.read<BuoyancyForce>().forces;
        auto const& centres = access.read<CentreOfBuoyancy>().centres;
        auto const& positions = access.read<Position>();
        auto const& rotations = access.read<Rotation>();
        access.forChunks(forces.size(), [&](Caller& caller, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                ObjectId const id = forces[i].object;
                if (Position const* const position = positions.find(id)) { // otherwise it was destroyed
                    Rotation const* const rotation = rotations.find(id);
                    double const angle = rotation == nullptr ? 0 : rotation->angle;
                    Vec2 const point = position->value + rotated(centres[i].centre, angle);
                    caller.call(AddForceToPoint{id, point, forces[i].force}, forces[i].event);
                }
            }
        });
    }
};

} // namespace trembler
