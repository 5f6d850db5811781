#include "insight/miss/miss_meter.hpp"
#include "puzzle/goals/conditions/table.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/measured_run.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::insight {
namespace {

LevelFile missLevel(std::string const& name) {
    return loadLevel(gameData().registry, gameData().home / "levels" / (name + ".json"));
}

TEST(MissMeter, KnowsEveryKindOfCondition) {
    std::vector<std::string_view> const keys = measurableKinds();
    for (ConditionKind const* const kind : conditionKinds()) {
        EXPECT_EQ(std::count(keys.begin(), keys.end(), kind->key()), 1) << kind->key();
    }
    EXPECT_EQ(keys.size(), conditionKinds().size());
}

TEST(MissMeter, IsZeroIfTheLevelIsSolved) {
    LevelFile const level = missLevel("first/1-first-contact");
    LevelRuns const runs(gameData(), level);
    MeasuredRun const measured = measuredRun(runs, {*level.findSolution("the spanner")}, {});
    ASSERT_TRUE(measured.run.solved);
    EXPECT_EQ(measured.miss.measure, 0);
    ASSERT_EQ(measured.miss.goals.size(), measured.run.goals.size());
    for (std::size_t i = 0; i < measured.miss.goals.size(); ++i) {
        EXPECT_EQ(measured.miss.goals[i].met, measured.run.goals[i].frame);
        EXPECT_EQ(measured.miss.goals[i].nearest.measure, 0);
    }
}

TEST(MissMeter, NamesTheGapOfACircuit) {
    LevelFile const level = missLevel("first/1-first-contact");
    LevelRuns const runs(gameData(), level);
    MeasuredRun const measured = measuredRun(runs, {}, {.frames = 120});
    ASSERT_FALSE(measured.run.solved);
    GoalMiss const& current = measured.miss.goals.front();
    ASSERT_EQ(current.id, "current");
    EXPECT_EQ(current.nearest.lack, Lack::gap);
    ASSERT_EQ(current.nearest.gaps.size(), 1U);
    EXPECT_EQ(current.nearest.gaps.front().nameA, "left contact");
    EXPECT_EQ(current.nearest.gaps.front().nameB, "right contact");
    EXPECT_GT(current.nearest.by, 0.02);
    EXPECT_LT(current.nearest.by, 1);
    GoalMiss const& held = measured.miss.goals.back();
    EXPECT_EQ(held.nearest.lack, Lack::distance);
    ASSERT_FALSE(held.nearest.besides.empty()); // the magnet was off
    EXPECT_EQ(held.nearest.besides.front().lack, Lack::gap);
}

TEST(MissMeter, AConductorInTheGapIsNearerThanOneBesideIt) {
    LevelFile const level = missLevel("first/1-first-contact");
    LevelRuns const runs(gameData(), level);
    Solution solution = *level.findSolution("the spanner");
    double last = 0;
    for (double const away : {0.0, 0.3, 0.6, 0.9}) { // m above the gap, hung there for a frame
        Variation varied{solution};
        varied.solution.placements.front().at.y += 1 + away;
        double const measure = measuredRun(runs, varied, {.frames = 1}).miss.measure;
        EXPECT_GE(measure, last) << away;
        last = measure;
    }
}

TEST(MissMeter, IsTheSameInEveryRun) {
    LevelFile const level = missLevel("first/2-into-the-basket");
    LevelRuns const runs(gameData(), level);
    MeasuredRun const one = measuredRun(runs, {}, {.frames = 300});
    MeasuredRun const two = measuredRun(runs, {}, {.frames = 300});
    EXPECT_EQ(one.miss.measure, two.miss.measure);
    EXPECT_EQ(one.miss.frame, two.miss.frame);
    EXPECT_EQ(one.run.stateHash, two.run.stateHash);
}

} // namespace
} // namespace trembler::insight
