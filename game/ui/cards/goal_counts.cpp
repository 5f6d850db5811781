#include "game/ui/cards/goal_counts.hpp"

#include "puzzle/goals/read_goals.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

int countIn(Condition const& goal) {
    return goal.seconds ? 0 : goal.kind->countedSteps(goal);
}

} // namespace

std::vector<int> goalCounts(LevelFile const& level) {
    std::vector<int> counts;
    auto const condition = readGoals(level);
    if (!condition) {
        return counts;
    }
    for (Condition const& goal : goalsOf(*condition)) {
        counts.push_back(countIn(goal));
    }
    return counts;
}

int reachedOf(GoalStatus const& goal, int count) {
    if (goal.met) {
        return count;
    }
    return std::clamp(static_cast<int>(std::floor(goal.progress * count + 1e-6)), 0, count);
}

} // namespace trembler::ui
