// How often something has to be for a goal to be met, for goals that count.
#pragma once

#include "puzzle/goals/goal_judge.hpp"

#include <string>
#include <vector>

namespace trembler::ui {

/// For each goal of a level, in the order of GoalJudge::status(): how many objects or steps it counts, if it
/// counts more than one; else 0. Goals that are to last for a time count seconds and not these.
[[nodiscard]] std::vector<int> goalCounts(LevelFile const& level);

/// How many of them there are at present.
[[nodiscard]] int reachedOf(GoalStatus const& goal, int count);

} // namespace trembler::ui
