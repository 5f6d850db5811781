// The forces between magnets, and between magnets and the objects that they attract: every pair.
#pragma once

#include "physics/inverse_square/kernels.hpp"
#include "physics/magnetism/magnetic_level.hpp"

namespace trembler {

/// Every pair of poles: F = µ0/4π · q1 q2 r / (r² + s²)^(3/2) (Gilbert's model, softened), like poles repel.
/// A susceptible object is attracted by any pole, at its centre of mass, as if it were a pole of that
/// strength and of the opposite sign; the thesis's simplification of induced magnetism (6.6).
class MagneticForces final : public MagneticLevel<MagneticForces> {
public:
    static constexpr ComponentText text{
        .name = "Magnetic Forces",
        .effect = "magnetism",
        .level = "pairwise",
        .work = "For each pair of magnets, calculates the attracting and repelling "
                "forces and exports the accumulated value.",
        .rank = 1};

    // The sum at each receiver is computed separately, so no bit depends on threads.
    void sum(Access& access, MagneticSum, inverse_square::Points const& sources,
             inverse_square::Points const& receivers, MagneticTotals totals) {
        constexpr std::size_t receiversToARange = 64; // few, as each has a sum over all sources
        auto const sumUp = [&](std::size_t begin, std::size_t end) {
            inverse_square::addAllPairs(sources, receivers, begin, end, magneticSoftening * magneticSoftening,
                                        totals.forces, totals.stiffness);
        };
        access.forRanges(receivers.size(), sumUp, receiversToARange);
    }
};

} // namespace trembler
