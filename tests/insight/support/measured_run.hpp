// How nearly a run solved its level, for tests.
#pragma once

#include "insight/miss/miss_meter.hpp"

#include <memory>

namespace trembler::insight {

/// A run and how nearly it solved the level.
struct MeasuredRun {
    RunResult run;
    LevelMiss miss; ///< without goals, and of measure 1, if the run has a fault
};

/// Runs a variation and measures it.
[[nodiscard]] inline MeasuredRun measuredRun(LevelRuns const& runs, Variation const& variation,
                                             RunLimits const& limits) {
    MeasuredRun measured;
    std::unique_ptr<MissMeter> meter;
    RunObserver observer;
    observer.begin = [&](LevelRun const& run) {
        meter = std::make_unique<MissMeter>(runs.level(), run.world());
    };
    observer.frame = [&](LevelRun const& run) {
        meter->look(run.world());
        return true;
    };
    measured.run = runs.run(variation, limits, observer);
    if (meter != nullptr && !measured.run.fault) {
        measured.miss = meter->result();
    }
    return measured;
}

} // namespace trembler::insight
