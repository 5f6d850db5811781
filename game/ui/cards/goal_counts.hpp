// The number of steps or objects that a goal counts until it is met.
#pragma once

#include "puzzle/goals/goal_judge.hpp"

#include <string>
#include <vector>

namespace trembler::ui {

/// For each goal of a level, in the order of GoalJudge::status(): how many objects or steps it counts, if it
/// counts more than one; else 0. Also 0 for goals that must hold for a time: their progress is in seconds.
[[nodiscard]] std::vector<int> goalCounts(LevelFile const& level);

/// How many of `count` steps or objects of a goal there are at present.
[[nodiscard]] int reachedOf(GoalStatus const& goal, int count);

} // namespace trembler::ui
