// The forces between very many magnets: far clusters of poles are summed as wholes.
#pragma once

#include "physics/inverse_square/tree.hpp"
#include "physics/magnetism/magnetic_level.hpp"

#include <array>

namespace trembler {

class Store;

/// The forces of MagneticForces by a tree (see inverse_square::Tree). Clusters contain poles of both signs:
/// poles that cancel in the sum still act by their dipole and second moments. The settings' opening angle
/// defines which clusters are far; docs/measurements/accuracy.md has the errors.
class MagneticTree final : public MagneticLevel<MagneticTree> {
public:
    static constexpr ComponentText text{
        .name = "Magnetic Tree",
        .effect = "magnetism",
        .level = "tree",
        .work = "Adds up the forces that magnets exert, with distant clusters of poles as wholes.",
        .rank = 0};
    /// The number of objects with poles from which it is three times as fast as all pairs; it is faster from
    /// about 300 on (bench_many_bodies).
    static constexpr std::size_t worthwhile = 1500;
    static bool suits(Store const& store);

    void sum(Access& access, MagneticSum sum, inverse_square::Points const& sources,
             inverse_square::Points const& receivers, MagneticTotals totals);

private:
    std::array<inverse_square::Tree, magneticSums> trees_; // members to reuse their memory
};

} // namespace trembler
