// What the player did by hand that kept a goal from being met.
#pragma once

#include "insight/why/answer.hpp"

namespace trembler::insight {

/// Adds to the nearest miss of a goal each of the player's deeds, see deedsOf(), without which the run meets
/// the goal or comes clearly nearer; of at most eight, the first ones. A cut that the miss names as a gap is
/// not told again. Adds nothing if it was stopped.
void addOwnDeeds(LevelRuns const& runs, Solution const& solution, AskOptions const& options, Answer& answer);

} // namespace trembler::insight
