// Placements that a less exact player would have made.
#pragma once

#include "insight/chance/counter_random.hpp"
#include "insight/trial/level_under_test.hpp"
#include "runtime/level/model/level.hpp"

#include <optional>

namespace trembler::insight {

/// How far placements are displaced.
struct Jitter {
    double distance = 0.02; ///< m, at most, in any direction; the grid of the window has steps of 0.05 m
    double angle = 2;       ///< degrees, at most, to either side
};

/// The solution with every placement displaced, evenly distributed over a disc and over a range of angles. If
/// a player could not place the parts so (a part would overlap something, or lie outside the area for
/// placing), others are drawn, up to 64 times; `redrawn` counts them. Nothing if none of them fits. Inputs
/// stay as they are.
[[nodiscard]] std::optional<Solution> jittered(LevelUnderTest const& level, Solution const& solution,
                                               Jitter const& jitter, CounterRandom& random, int& redrawn);

} // namespace trembler::insight
