// What stood in the way of the object of a goal that was not met, confirmed by runs without it.
#pragma once

#include "insight/why/answer.hpp"

namespace trembler::insight {

/// Extends the nearest miss of an answer about a goal that was not met, if it is a distance: of each placed
/// part, and of each movable object of the level, that touched the goal's object in the run, or something
/// that joints tie it to, a miss of Lack::blocked, with the result of the run without it in Miss::ifClosed.
/// Only if that run, without the part or with both passing through each other, meets the goal or comes
/// clearly nearer to it; at most `mostInTheWay` are tested, placed parts first, then by their first touch.
/// Counts the runs in `answer`; a stopped search adds nothing. A pure function of its arguments, for any
/// number of threads.
void addInTheWay(LevelRuns const& runs, Solution const& solution, AskOptions const& options, Answer& answer);
inline constexpr std::size_t mostInTheWay = 8;

} // namespace trembler::insight
