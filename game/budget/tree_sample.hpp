// Estimates the error of tree forces from some of the tree's groups.
#pragma once

#include "game/budget/knob.hpp"
#include "physics/inverse_square/tree.hpp"
#include "runtime/world/world.hpp"

#include <cstdint>
#include <vector>

namespace trembler::budget {

/// Receivers traverse a tree in groups of neighbours, and a group opens more clusters than each of its
/// members alone would: so whole groups are sampled, evenly spread, and only their movable members count.
class TreeSample {
public:
    static constexpr std::size_t groups = 3;

    explicit TreeSample(World const& world) : world_(world) {}
    /// Adds one sum of the effect, with all its receivers; see inverse_square::Tree.
    void add(inverse_square::Points const& sources, inverse_square::Points const& receivers,
             bool ownElsewhere, double softening2);
    /// The error at an opening angle. Errors of different sums and poles on the same body are added as
    /// independent ones.
    [[nodiscard]] Error errorAt(double openingAngle) const;

private:
    struct Sum {
        inverse_square::Tree tree;
        std::size_t receivers = 0;
        double softening2 = 0; ///< m²
        /// Index ranges in the tree's order of receivers.
        std::vector<std::pair<std::size_t, std::size_t>> ranges;
        struct Looked {
            std::size_t row = 0; ///< index of the receiver as given
            std::uint32_t owner = 0;
            double mass = 0; ///< kg
            Vec2 right;      ///< the exact force, N
        };
        std::vector<Looked> looked;
    };

    World const& world_;
    std::vector<Sum> sums_;
};

} // namespace trembler::budget
