// Checks a recorded solution against the world with its placements.
#pragma once

#include "puzzle/session/run.hpp"

namespace trembler {

/// Complains about faults that only the world before its first frame shows: changes that it does not allow,
/// and inputs that name a piece which no composite part has, or cut a wire that does not exist or has been
/// cut. The rest has been checked when the solution was read (InputCheck).
void checkSolution(Registry const& registry, LevelFile const& level, LevelRun const& run,
                   Solution const& solution, Problems& problems);

} // namespace trembler
