#include "game/ui/cards/goal_counts.hpp"

#include "puzzle/goals/read_goals.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

int countIn(nlohmann::json const& goal) {
    if (!goal.is_object() || goal.contains("for")) {
        return 0;
    }
    if (auto const steps = goal.find("sequence"); steps != goal.end() && steps->is_array()) {
        return steps->size() > 1 ? static_cast<int>(steps->size()) : 0;
    }
    auto const count = goal.find("count");
    if (count == goal.end() || !count->is_object()) {
        return 0;
    }
    auto const most = count->find("at_least");
    bool const counts = most != count->end() && most->is_number_integer();
    return counts && most->get<int>() > 1 ? most->get<int>() : 0;
}

} // namespace

std::vector<int> goalCounts(LevelFile const& level) {
    std::vector<int> counts;
    auto const condition = readGoals(level);
    if (!condition) {
        return counts;
    }
    auto const goals = goalsOf(*condition);
    if (goals.data() == &*condition) { // it is one goal as a whole
        return {countIn(level.goals)};
    }
    for (char const* const key : {"all", "sequence"}) {
        if (auto const list = level.goals.find(key); list != level.goals.end() && list->is_array()) {
            for (nlohmann::json const& goal : *list) {
                counts.push_back(countIn(goal));
            }
        }
    }
    counts.resize(goals.size());
    return counts;
}

int reachedOf(GoalStatus const& goal, int count) {
    if (goal.met) {
        return count;
    }
    return std::clamp(static_cast<int>(std::floor(goal.progress * count + 1e-6)), 0, count);
}

} // namespace trembler::ui
