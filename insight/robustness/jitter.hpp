// Placements and deeds of a less exact player.
#pragma once

#include "insight/chance/counter_random.hpp"
#include "insight/trial/level_under_test.hpp"
#include "runtime/level/model/level.hpp"

#include <optional>

namespace trembler::insight {

/// How far placements and deeds are displaced.
struct Jitter {
    double distance = 0.02; ///< m, at most, in any direction; the grid of the window has steps of 0.05 m
    double angle = 2;       ///< degrees, at most, to either side
    double seconds = 0.1;   ///< s, at most, that a deed comes earlier or later
};

/// Whether a solution has anything to displace: wires have no places.
[[nodiscard]] bool canBeDisplaced(Solution const& solution);

/// The solution with every placement displaced, evenly distributed over a disc and over a range of angles. If
/// a player could not place the parts so (a part would overlap something, or lie outside the area for
/// placing), others are drawn, up to 64 times; `redrawn` counts them. Nothing if none of them fits. Each
/// deed, as deedsOf() lists them, comes earlier or later, but not before the same hand has ended its last
/// one; where a hand takes hold and moves to is displaced by the same vector.
[[nodiscard]] std::optional<Solution> jittered(LevelUnderTest const& level, Solution const& solution,
                                               Jitter const& jitter, CounterRandom& random, int& redrawn);

} // namespace trembler::insight
