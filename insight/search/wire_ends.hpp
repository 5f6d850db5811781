// Wires that a search may lay and cut.
#pragma once

#include "insight/chance/counter_random.hpp"
#include "insight/trial/level_under_test.hpp"
#include "runtime/level/model/level.hpp"

namespace trembler::insight {

/// Adds a wire between two of the level's own conductors that nothing connects yet, if the toolbox has one
/// left. False if there is none to be laid.
bool addRandomWire(LevelUnderTest const& level, Solution& solution, CounterRandom& random);
/// Adds as many of them as chance wants, up to all that the toolbox has.
void addRandomWires(LevelUnderTest const& level, Solution& solution, CounterRandom& random);

} // namespace trembler::insight
