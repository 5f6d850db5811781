// The forces between magnets that are near one another.
#pragma once

#include "physics/inverse_square/grid.hpp"
#include "physics/magnetism/magnetic_level.hpp"

#include <array>

namespace trembler {

class Store;

/// Poles act in full up to this share of the cutoff, and smoothly less from there on.
inline constexpr double fullShareOfCutoff = 0.8;

/// The cutoff in m: the one set, or the one that follows from the threshold. The force between the two
/// strongest magnets of the world falls to the threshold F at √(µ0/4π q1 q2 / F); up to there every pair acts
/// in full. Strengths count as they are stated: a magnet that is switched off now may be on in the next
/// frame, and the cutoff must not move.
[[nodiscard]] double magneticCutoff(MagnetismSettings const& settings,
                                    Column<MagneticStrength> const& strengths);

/// The forces of MagneticForces, cut off. Forces end smoothly and are central, so they have a potential and
/// crossing the cutoff neither gives nor takes energy. The many weak pulls from afar are left out.
class MagneticGrid final : public MagneticLevel<MagneticGrid> {
public:
    static constexpr ComponentText text{
        .name = "Magnetic Grid",
        .effect = "magnetism",
        .level = "grid",
        .work = "Adds up the forces that magnets within a cutoff length exert.",
        .rank = 2}; // never picked automatically: the error has no bound that follows from the scene

    /// Unless the world states a cutoff or a threshold that takes away forces which matter.
    static bool faithful(Store const& store);
    void sum(Access& access, MagneticSum sum, inverse_square::Points const& sources,
             inverse_square::Points const& receivers, MagneticTotals totals);

private:
    std::array<inverse_square::Grid, magneticSums> grids_; // each keeps its memory
};

} // namespace trembler
