// How far off forces by a tree are, found out on a few of its groups.
#pragma once

#include "game/budget/knob.hpp"
#include "physics/inverse_square/tree.hpp"
#include "runtime/world/world.hpp"

#include <cstdint>
#include <vector>

namespace trembler::budget {

/// Receivers walk through a tree in groups of neighbours, which opens more clusters than each of them would:
/// so whole groups are looked at, evenly spread, and only what can move in them counts.
class TreeSample {
public:
    static constexpr std::size_t groups = 3;

    explicit TreeSample(World const& world) : world_(world) {}
    /// Adds one sum of the effect, with all its receivers; see inverse_square::Tree.
    void add(inverse_square::Points const& sources, inverse_square::Points const& receivers,
             bool ownElsewhere, double softening2);
    /// A body feels the errors of all the sums and poles that were looked at as if they were independent.
    [[nodiscard]] Error errorAt(double openingAngle) const;

private:
    struct Sum {
        inverse_square::Tree tree;
        std::size_t receivers = 0;
        double softening2 = 0;                                   ///< m²
        std::vector<std::pair<std::size_t, std::size_t>> ranges; ///< of ordered receivers
        struct Looked {
            std::size_t row = 0; ///< of the receivers as given
            std::uint32_t owner = 0;
            double mass = 0; ///< kg
            Vec2 right;      ///< N
        };
        std::vector<Looked> looked;
    };

    World const& world_;
    std::vector<Sum> sums_;
};

} // namespace trembler::budget
