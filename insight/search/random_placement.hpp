// Random placements, with which a search is compared.
#pragma once

#include "insight/chance/counter_random.hpp"
#include "insight/trial/level_under_test.hpp"
#include "runtime/level/model/level.hpp"

#include <optional>
#include <string>
#include <vector>

namespace trembler::insight {

/// The areas in which parts may be placed: the areas that the level states, else its bounds, else a rectangle
/// around all that it has, with a margin of 1 m.
[[nodiscard]] std::vector<Area> placingAreas(LevelUnderTest const& level);

/// A part whose centre is in a random place, in addition to what the solution places: evenly distributed over
/// the areas for placing, upright or turned by a random multiple of 15 degrees, so that it overlaps nothing;
/// it may stick out of the areas. Nothing if 64 places were tried without success, or the toolbox has none
/// left.
[[nodiscard]] std::optional<Placement> droppedAtRandom(LevelUnderTest const& level, Solution const& others,
                                                       std::string const& part, CounterRandom& random);
/// The same where a player can place it: wholly in the areas.
[[nodiscard]] std::optional<Placement> placedAtRandom(LevelUnderTest const& level, Solution const& others,
                                                      std::string const& part, CounterRandom& random);

/// A solution of 1 to 4 random parts of the toolbox in random places, and of random wires if the toolbox has
/// some.
[[nodiscard]] Solution randomSolution(LevelUnderTest const& level, CounterRandom& random);

/// How many of a part the toolbox has left beside what the solution places; may be unlimitedCount.
[[nodiscard]] int leftInToolbox(LevelUnderTest const& level, Solution const& solution,
                                std::string const& part);

} // namespace trembler::insight
