#include "insight/trial/nearness.hpp"

#include <algorithm>

namespace trembler::insight {

Nearness::Nearness(LevelUnderTest const&, LevelRun const&) {}

void Nearness::look(LevelRun const& run) {
    auto const& goals = run.judge().status();
    double missing = 0;
    for (GoalStatus const& goal : goals) {
        missing += 1 - goal.progress;
    }
    if (!goals.empty()) {
        miss_ = std::min(miss_, missing / static_cast<double>(goals.size()));
    }
}

} // namespace trembler::insight
