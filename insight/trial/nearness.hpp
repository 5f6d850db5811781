// How nearly a run met the goals of its level.
#pragma once

#include "insight/trial/level_under_test.hpp"
#include "puzzle/session/run.hpp"

namespace trembler::insight {

/// Watches a run and remembers its nearest approach to the goals. One thread at a time.
class Nearness {
public:
    /// For a run that has not begun. Both must outlive it.
    Nearness(LevelUnderTest const& level, LevelRun const& run);
    /// To be called after every frame.
    void look(LevelRun const& run);
    /// 0 to 1: how far the run was from meeting all goals, at its nearest.
    [[nodiscard]] double miss() const { return miss_; }

private:
    double miss_ = 1;
};

} // namespace trembler::insight
