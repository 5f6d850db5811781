#include "insight/trial/solution_text.hpp"
#include "insight/trial/trial.hpp"
#include "puzzle/run/runner.hpp"
#include "runtime/placement.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace trembler::insight {
namespace {

TEST(Trial, EndsAsTheRunnerDoes) {
    // With and without the rule that a world at rest is not run to the end.
    for (char const* const name :
         {"first/1-first-contact.json", "2-electricity/1-both-gaps.json", "4-water/1-sink-or-float.json"}) {
        LevelUnderTest const level(gameData(), testedFile(name));
        for (Solution const& solution : level.level().solutions) {
            Session session(gameData().registry, gameData().parts, level.level());
            session.load(solution);
            RunOptions options;
            options.frames = framesOf(solution);
            options.stopWhenSolved = true;
            RunReport const whole = trembler::run(session, "", options);
            TrialResult const trial = tryOut(
                level, solution, {.frames = framesOf(solution), .mustFit = false, .measureMiss = true});
            EXPECT_EQ(trial.solved, whole.solved) << name << ", " << solution.name;
            EXPECT_EQ(trial.solved, solution.solves) << name << ", " << solution.name;
            EXPECT_EQ(trial.miss == 0, trial.solved);
            EXPECT_LE(trial.frame, whole.frames);
            if (whole.solved) {
                EXPECT_EQ(trial.frame, whole.solvedFrame);
            }
            EXPECT_EQ(trialFrom(toText(trial)), trial);
        }
    }
}

TEST(Trial, RunsOnlyWhatAPlayerCouldPlace) {
    EXPECT_FALSE(tryOut(firstContact(), placing("steel bar", {2.5, 2}), {}).fits) << "outside the area";
    EXPECT_FALSE(tryOut(firstContact(), placing("iron ball", {-1.8, 1.5}), {}).fits) << "not in the toolbox";
    Solution overlapping = placing("steel bar", {-1.8, 1.4});
    overlapping.placements.push_back(placing("wooden bar", {-1.8, 1.42}).placements.front());
    EXPECT_FALSE(tryOut(firstContact(), overlapping, {}).fits);
    EXPECT_TRUE(whyNotPlaced(firstContact(), overlapping).has_value());
    EXPECT_TRUE(tryOut(firstContact(), placing("steel bar", {-1.8, 1.15}), {}).solved);
}

// The level's only gap, between its contacts; nothing is lacking where it was not measured.
TEST(Trial, TellsWhereSomethingWasLacking) {
    Solution const wood = placing("wooden bar", {-1.8, 1.15});
    TrialResult const trial = tryOut(firstContact(), wood, {.measureMiss = true});
    ASSERT_FALSE(trial.lacking.empty());
    Lacking const& gap = trial.lacking.front();
    EXPECT_TRUE(gap.isGap);
    Vec2 const left =
        firstContact().world().find<Position>(firstContact().world().store().find("left contact"))->value;
    EXPECT_LT(std::min(length(gap.from - left), length(gap.to - left)), 0.3) << "on the contact";
    EXPECT_EQ(trialFrom(toText(trial)), trial);
    EXPECT_TRUE(tryOut(firstContact(), wood, {}).lacking.empty());
}

TEST(Trial, IsTheSameInEveryThread) {
    std::vector<std::string> texts(4);
    std::vector<std::thread> threads;
    threads.reserve(texts.size());
    for (std::string& text : texts) {
        threads.emplace_back([&text] {
            text =
                toText(tryOut(firstContact(), placing("spanner", {-1.7, 1.3}, 0.1), {.measureMiss = true}));
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(std::count(texts.begin(), texts.end(), texts.front()), 4);
}

TEST(SolutionText, IsReadBackBitForBit) {
    Solution solution = placing("spanner", {0.1, 1.0 / 3}, 0.7);
    solution.placements.front().flipped = true;
    solution.wires.push_back({"a", "b", "", "wire"});
    RecordedInput input;
    input.frame = 7;
    input.kind = PlayerInput::Kind::grab;
    input.object = "iron ball";
    input.at = {0.1, -0.2};
    input.hand = 1;
    solution.inputs.push_back(input);
    Solution const back = solutionFrom(toText(solution));
    EXPECT_EQ(toText(back), toText(solution));
    EXPECT_EQ(back.placements.front().at, solution.placements.front().at);
    EXPECT_EQ(back.inputs.front().hand, 1);
    EXPECT_NE(identityOf(back), identityOf(placing("spanner", {0.1, 1.0 / 3}, 0.7)));
}

TEST(SolutionText, IdentifiesWhatDecidesTheRun) {
    Solution const solution = placing("spanner", {0.1, 0.2});
    Solution renamed = solution;
    renamed.name = "another name";
    EXPECT_EQ(identityOf(renamed), identityOf(solution));
    Solution longer = solution;
    longer.frames = 900;
    EXPECT_NE(identityOf(longer), identityOf(solution));
    Solution changed = solution;
    RecordedChange roughly;
    roughly.frame = 5;
    roughly.subject = "electricity";
    roughly.level = "on and off";
    changed.changes.push_back(roughly);
    EXPECT_NE(identityOf(changed), identityOf(solution));
    EXPECT_NE(identityOf(placing("spanner", {0.1, 0.2}, 0.1)), identityOf(solution));
}

} // namespace
} // namespace trembler::insight
