// The reason, confirmed by further runs, for which the object of a goal that was not met did not get there.
#pragma once

#include "insight/why/answer.hpp"

namespace trembler::insight {

/// Extends the nearest miss of an answer about a goal that was not met, if it is a distance:
///
/// - If the goal's object, or a body tied to it by joints, could be moved by a motor that had no current,
///   Miss::besides gets the gaps of the motor's circuit.
/// - If the object touched a movable body that a motor or an electromagnet could move, directly or through
///   joints, and that device had no current, Miss::besides gets a miss of Lack::blocked, and after it the
///   gaps of the device's circuit. The same through a second body that stood in the way of the first one.
///
/// Each is added only if runs confirm it: a run in which the bodies pass through each other, and one in which
/// wires close the gaps and the device has current, both come clearly nearer to the goal. Of all gaps among
/// the misses besides, Miss::ifClosed states the result of closing them. Counts the runs in `answer`; a
/// stopped search adds nothing. A pure function of its arguments, for any number of threads.
void addHeldBack(LevelRuns const& runs, Solution const& solution, AskOptions const& options, Answer& answer);

} // namespace trembler::insight
