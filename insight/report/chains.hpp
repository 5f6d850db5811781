// Why each goal is met in recorded solutions.
#pragma once

#include "insight/run/level_runs.hpp"
#include "insight/spread/workers.hpp"
#include "insight/trial/level_under_test.hpp"
#include "insight/why/answer.hpp"

#include <string>
#include <vector>

namespace trembler::insight {

/// A goal of a level.
struct ReportedGoal {
    std::string id;
    std::string text; ///< as a sentence in English
};
/// In the level's order.
[[nodiscard]] std::vector<ReportedGoal> goalsOf(LevelUnderTest const& level);

/// For each solution the answer for each goal, see why(); of a goal that is not met, and if the work was
/// stopped before, none.
[[nodiscard]] std::vector<std::vector<Answer>> chainsOf(LevelUnderTest const& level, LevelRuns const& runs,
                                                        std::vector<Solution const*> const& solutions,
                                                        std::vector<ReportedGoal> const& goals,
                                                        Workers& workers);

} // namespace trembler::insight
