#include "insight/robustness/robustness.hpp"
#include "insight/search/random_placement.hpp"
#include "insight/trial/trial.hpp"
#include "tests/insight/support/on_threads.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace trembler::insight {
namespace {

SolvedBy solvedBy(char const* name) {
    Solution const* const solution = firstContact().level().findSolution(name);
    return {solution, tryOut(firstContact(), *solution, {}).frame};
}

TEST(Jitter, StaysWithinItsReachAndWhatAPlayerCanPlace) {
    Solution const& bar = *firstContact().level().findSolution("the steel bar");
    Jitter const jitter{.distance = 0.05, .angle = 3};
    double farthest = 0;
    for (std::uint64_t n = 0; n < 200; ++n) {
        CounterRandom random(keyOf(1, {"test"}, n));
        int redrawn = 0;
        auto const displaced = jittered(firstContact(), bar, jitter, random, redrawn);
        ASSERT_TRUE(displaced.has_value());
        Placement const& placement = displaced->placements.front();
        double const distance = length(placement.at - bar.placements.front().at);
        farthest = std::max(farthest, distance);
        EXPECT_LE(distance, 0.05);
        EXPECT_LE(std::abs(placement.angle), 3 * pi / 180);
        EXPECT_FALSE(whyNotPlaced(firstContact(), *displaced).has_value());
    }
    EXPECT_GT(farthest, 0.045);
}

TEST(Jitter, MovesDeedsInTheirOrder) {
    Solution solution;
    solution.inputs = {{10, PlayerInput::Kind::grab, "switch", "", {1, 1}, "", 0},
                       {30, PlayerInput::Kind::move, "", "", {2, 1}, "", 0},
                       {40, PlayerInput::Kind::release, "", "", {}, "", 0},
                       {42, PlayerInput::Kind::grab, "ball", "", {3, 1}, "", 0},
                       {43, PlayerInput::Kind::cut, "a", "b", {}, "", 0}};
    EXPECT_TRUE(canBeDisplaced(solution));
    EXPECT_FALSE(canBeDisplaced({}));
    Jitter const jitter{.distance = 0.02, .angle = 2, .seconds = 0.1}; // 6 frames
    std::int64_t earliest = 10;
    std::int64_t latest = 10;
    for (std::uint64_t n = 0; n < 200; ++n) {
        CounterRandom random(keyOf(1, {"deeds"}, n));
        int redrawn = 0;
        auto const made = jittered(firstContact(), solution, jitter, random, redrawn);
        ASSERT_TRUE(made);
        ASSERT_EQ(made->inputs.size(), 5U);
        EXPECT_TRUE(std::is_sorted(made->inputs.begin(), made->inputs.end(),
                                   [](auto const& a, auto const& b) { return a.frame < b.frame; }));
        std::vector<RecordedInput> hand = made->inputs;
        std::erase_if(hand, [](auto const& input) { return input.kind == PlayerInput::Kind::cut; });
        ASSERT_EQ(hand.size(), 4U);
        EXPECT_EQ(hand[0].object, "switch");
        EXPECT_EQ(hand[1].kind, PlayerInput::Kind::move);
        EXPECT_EQ(hand[2].kind, PlayerInput::Kind::release) << "before the same hand takes hold again";
        EXPECT_EQ(hand[3].object, "ball");
        EXPECT_EQ(hand[1].frame - hand[0].frame, 20U) << "a grip is displaced as a whole";
        EXPECT_NEAR(length(hand[1].at - hand[0].at - Vec2{1, 0}), 0, 1e-12);
        EXPECT_LE(length(hand[0].at - Vec2{1, 1}), 0.02);
        earliest = std::min(earliest, static_cast<std::int64_t>(hand[0].frame));
        latest = std::max(latest, static_cast<std::int64_t>(hand[0].frame));
    }
    EXPECT_EQ(earliest, 4);
    EXPECT_EQ(latest, 16);
}

TEST(Robustness, IsHighWhereABarLiesAcrossAGapAndLowWhereItIsThrownFar) {
    RobustnessOptions options;
    options.runs = 30;
    Workers workers(onThreads(2));
    auto const near = robustnessOf(firstContact(), {solvedBy("the steel bar")}, options, workers);
    EXPECT_EQ(near.front().runs, 30);
    EXPECT_EQ(near.front().share(), 1);
    options.jitter = {.distance = 0.8, .angle = 90};
    auto const far = robustnessOf(firstContact(), {solvedBy("the steel bar")}, options, workers);
    EXPECT_LT(far.front().share(), 0.7);
    EXPECT_GT(far.front().solved, 0);
    // The same with one thread, and other displacements with another seed.
    Workers one(onThreads(1));
    EXPECT_EQ(robustnessOf(firstContact(), {solvedBy("the steel bar")}, options, one).front().solved,
              far.front().solved);
}

TEST(RandomDrops, OnlyCountWhatFits) {
    Workers workers(onThreads(2));
    auto const drops = randomDrops(firstContact(), 20, 600, 1, workers);
    ASSERT_EQ(drops.size(), 3U);
    EXPECT_EQ(drops[0].part, "steel bar");
    EXPECT_EQ(drops[0].runs, 20);
    EXPECT_EQ(drops[1].part, "wooden bar");
    EXPECT_EQ(drops[1].solved, 0) << "wood does not conduct";
}

TEST(RandomPlacement, FitsAndLiesInTheArea) {
    for (std::uint64_t n = 0; n < 50; ++n) {
        CounterRandom random(n);
        auto const placement = placedAtRandom(firstContact(), {}, "spanner", random);
        ASSERT_TRUE(placement.has_value());
        Solution solution;
        solution.placements.push_back(*placement);
        EXPECT_FALSE(whyNotPlaced(firstContact(), solution).has_value());
        EXPECT_FALSE(placedAtRandom(firstContact(), solution, "spanner", random)) << "there is only one";
    }
}

} // namespace
} // namespace trembler::insight
