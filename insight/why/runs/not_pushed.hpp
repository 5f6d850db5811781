// Buttons, plates and levers that nothing pushed, or not hard enough, and whose contacts stayed open.
#pragma once

#include "insight/why/answer.hpp"

namespace trembler::insight {

/// Adds to the nearest miss of a goal, for each gap of a circuit that it names and that a push would have
/// closed, see neededPush(), the force that was missing. Each force is confirmed by two runs with a hand: one
/// that pushes a sixth harder closes the gap, one that pushes a sixth less does not. They are told only if
/// the run with such a push, or with two of them together, meets the goal or comes clearly nearer. Nothing is
/// added if the player used the hands, whose strength these runs change, or if it was stopped.
void addNotPushed(LevelRuns const& runs, Solution const& solution, AskOptions const& options, Answer& answer);

} // namespace trembler::insight
