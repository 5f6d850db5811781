// Why a level was not solved, for tests.
#pragma once

#include "insight/miss/miss_meter.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

namespace trembler::insight {

/// The explained miss of the level's first goal in a run of that many frames.
inline Miss explainedMiss(LevelFile const& level, std::uint64_t frames, Variation const& variation = {}) {
    LevelRuns const runs(gameData(), level);
    std::unique_ptr<MissMeter> meter;
    RunObserver observer;
    observer.begin = [&](LevelRun const& run) {
        meter = std::make_unique<MissMeter>(runs.level(), run.world(), MissMeter::For::explanation);
    };
    observer.frame = [&](LevelRun const& run) {
        meter->look(run.world());
        return true;
    };
    EXPECT_FALSE(runs.run(variation, {.frames = frames}, observer).fault);
    return meter->explained(0).nearest;
}

} // namespace trembler::insight
