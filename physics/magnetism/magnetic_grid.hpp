// The forces between magnets within a cutoff.
#pragma once

#include "physics/inverse_square/grid.hpp"
#include "physics/magnetism/magnetic_level.hpp"

#include <array>

namespace trembler {

class Store;

/// Forces are complete up to this share of the cutoff, and decrease smoothly beyond.
inline constexpr double fullShareOfCutoff = 0.8;

/// The cutoff in m: the stated one, or the one that follows from the threshold. The force between the two
/// strongest magnets of the world decreases to the threshold F at √(µ0/4π q1 q2 / F); up to there the forces
/// of all pairs are complete. Stated strengths count: a magnet that is off now may be on in the next frame,
/// and the cutoff must not change.
[[nodiscard]] double magneticCutoff(MagnetismSettings const& settings,
                                    Column<MagneticStrength> const& strengths);

/// The forces of MagneticForces, cut off. Forces decrease smoothly and are central, so they have a potential,
/// and crossing the cutoff does not change the energy. The many weak forces of far magnets are left out.
class MagneticGrid final : public MagneticLevel<MagneticGrid> {
public:
    static constexpr ComponentText text{
        .name = "Magnetic Grid",
        .effect = "magnetism",
        .level = "grid",
        .work = "Adds up the forces that magnets within a cutoff length exert.",
        .rank = 2}; // never chosen automatically: the scene implies no bound of the error

    /// Unless the world states a cutoff or a threshold that removes relevant forces.
    static bool faithful(Store const& store);
    void sum(Access& access, MagneticSum sum, inverse_square::Points const& sources,
             inverse_square::Points const& receivers, MagneticTotals totals);

private:
    std::array<inverse_square::Grid, magneticSums> grids_; // members to reuse their memory
};

} // namespace trembler
