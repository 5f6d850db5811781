// The costs of the effects and those of the ways to compute a level are means over the same run.
#include "insight/cost/accuracy_needed.hpp"
#include "insight/run/level_runs.hpp"
#include "tests/insight/support/on_threads.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::insight {
namespace {

/// In how many frames a solution solves the level.
std::uint64_t framesToSolve(LevelUnderTest const& level, Solution const& solution) {
    LevelRuns const runs(level.data(), level.level());
    RunResult const result = runs.run({solution, {}}, {.frames = 3600});
    EXPECT_TRUE(result.solved);
    return result.frames;
}

// Not over the minute hands off, in which nothing moves and a frame costs nearly nothing.
TEST(AccuracyNeeded, MeasuresTheEffectsAndTheWaysInTheSameRun) {
    std::vector<Solution> const& solutions = firstContact().level().solutions;
    std::size_t const measured = measuredRun(firstContact().level());
    ASSERT_LT(measured, solutions.size());
    EXPECT_TRUE(solutions[measured].solves);
    std::uint64_t const frames = framesToSolve(firstContact(), solutions[measured]);
    ASSERT_LT(frames, 3600U);
    for (EffectCost const& cost : effectCosts(firstContact(), solutions[measured])) {
        EXPECT_EQ(cost.frames, frames) << cost.effect;
    }
    Workers workers(onThreads(2));
    std::vector<WayToCompute> const ways = waysToCompute(firstContact(), workers);
    EXPECT_GT(std::count_if(ways.begin(), ways.end(), [](WayToCompute const& way) { return way.present; }),
              2);
    for (WayToCompute const& way : ways) {
        if (way.present) {
            EXPECT_EQ(way.frames, frames) << way.effect << " " << way.level;
        } else if (way.keepsAll) {
            EXPECT_GT(way.frames, 0U) << way.effect << " " << way.level;
            EXPECT_LT(way.frames, 3600U) << way.effect << " " << way.level;
        }
    }
}

// Each recorded run is compared with what is recorded about it, not only the run without input.
TEST(AccuracyNeeded, RunsEveryRecordedSolution) {
    for (std::size_t index = 0; index < firstContact().level().solutions.size(); ++index) {
        LevelFile level = firstContact().level();
        level.solutions[index].solves = !level.solutions[index].solves;
        std::string const name = level.solutions[index].name;
        LevelUnderTest const tested(gameData(), level, "changed");
        Workers workers(onThreads(2));
        for (WayToCompute const& way : waysToCompute(tested, workers)) {
            if (way.present) {
                EXPECT_EQ(way.differs, name) << way.effect << " " << way.level;
                EXPECT_FALSE(way.keepsAll);
            }
        }
    }
}

TEST(AccuracyNeeded, MeasuresTheRunWithoutInputIfNoSolutionSolvesTheLevel) {
    LevelFile level = firstContact().level();
    std::erase_if(level.solutions, [](Solution const& solution) { return solution.solves; });
    ASSERT_FALSE(level.solutions.empty()) << "the wooden bar";
    EXPECT_EQ(measuredRun(level), level.solutions.size());
    LevelUnderTest const tested(gameData(), level, "none");
    Workers workers(onThreads(2));
    for (WayToCompute const& way : waysToCompute(tested, workers)) {
        if (way.differs.empty()) {
            EXPECT_EQ(way.frames, 3600U) << way.effect << " " << way.level;
        }
    }
}

} // namespace
} // namespace trembler::insight
