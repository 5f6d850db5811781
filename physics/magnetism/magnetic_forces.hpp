// The forces between magnets, and between magnets and what they attract.
#pragma once

#include "physics/dynamics/shape.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/component/dps.hpp"
#include "runtime/placement.hpp"

namespace trembler {

/// Every pair of poles: F = µ0/4π · q1 q2 r / (r² + s²)^(3/2) (Gilbert's model, softened), like poles repel.
/// What is susceptible is attracted by any pole, at its centre of mass, as if it were a pole of that strength
/// and of the opposite sign; the thesis's simplification of induced magnetism (6.6).
class MagneticForces final
    : public Dps<MagneticForces,
                 Reads<Position, Rotation, Shape, MagneticPoles, MagneticStrength, Magnet, MagnetSwitching>,
                 Derives<MagneticForce>> {
public:
    static constexpr ComponentText text{
        .name = "Magnetic Forces",
        .effect = "magnetism",
        .level = "pairwise",
        .work = "For each pair of magnets, calculates the attracting and repelling "
                "forces and exports the accumulated value.",
        .cost = 1};
    using CalledFor = NeedsAll<Magnet, MagneticStrength, Position>;
    void update(Access& access);

private:
    struct Pole {
        ObjectId object;
        Vec2 at;         ///< m, in the world
        double strength; ///< A m; north positive
    };
    void findCentres(Access& access);
    void gather(Access& access);

    std::vector<Vec2> centres_;        // m, centres of mass in their own frames, by row of MagneticStrength
    std::uint64_t centresVersion_ = 0; // of what they were made from
    std::vector<Pole> poles_;          // those that act, ascending by object
    std::vector<Pole> soft_;           // what they attract, strength = susceptibility
};

/// µ0/4π in N/A².
inline constexpr double magneticConstant = 1e-7;

/// Force (N) on a pole at distance vector `r` (m, from it to the other pole) with strengths q1, q2 (A m).
[[nodiscard]] Vec2 poleForce(Vec2 r, double q1, double q2);

} // namespace trembler
