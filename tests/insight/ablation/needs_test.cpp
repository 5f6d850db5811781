#include "insight/ablation/needs.hpp"
#include "insight/trial/solution_text.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::insight {
namespace {

bool has(std::vector<std::string> const& list, std::string const& one) {
    return std::find(list.begin(), list.end(), one) != list.end();
}

TEST(Needs, LeaveOutWhatDoesNothing) {
    LevelRuns const runs(gameData(), firstContact().level());
    Solution solution = placing("wooden bar", {-0.9, 2.2});
    solution.placements.push_back(placing("steel bar", {-1.8, 1.15}).placements.front());
    RecordedInput input;
    input.kind = PlayerInput::Kind::cut;
    input.frame = 2000; // after the level is solved
    input.object = "battery plus";
    input.other = "left contact";
    solution.inputs.push_back(input);
    Needs const needs = needsOf(runs, solution, 600);
    ASSERT_TRUE(needs.solves);
    EXPECT_EQ(needs.parts, std::vector<std::string>{"steel bar"});
    EXPECT_TRUE(needs.deeds.empty());
    EXPECT_EQ(needs.least.placements.size(), 1U);
    EXPECT_EQ(needs.superfluous.size(), 2U);
    EXPECT_TRUE(has(needs.effects, "electricity"));
    EXPECT_TRUE(has(needs.effects, "magnetism")) << "it holds the ball";
    EXPECT_TRUE(has(needs.effects, "gravity")) << "it lays the bar on the contacts";
    EXPECT_FALSE(has(needs.effects, "sound"));
    EXPECT_EQ(toText(needsFrom(toText(needs), solution)), toText(needs));
}

TEST(Needs, TellWhenTheWholeSolutionSolvesAndWhenTheReducedOneDoes) {
    LevelRuns const runs(gameData(), firstContact().level());
    // The spanner, which falls farther, can do without the bar that lies on the contacts almost at once.
    Solution solution = *firstContact().level().findSolution("the spanner");
    solution.placements.front().at.y += 0.5;
    solution.placements.push_back(placing("steel bar", {-1.8, 1.0}).placements.front());
    Needs const needs = needsOf(runs, solution, 600);
    ASSERT_TRUE(needs.solves);
    ASSERT_EQ(needs.least.placements.size(), 1U);
    EXPECT_EQ(needs.least.placements.front().part, "spanner");
    EXPECT_EQ(runs.run({solution, {}}, {.frames = 600}).solvedFrame, needs.frame);
    EXPECT_EQ(runs.run({needs.least, {}}, {.frames = 600}).solvedFrame, needs.leastFrame);
    EXPECT_GT(needs.leastFrame, needs.frame);
    EXPECT_EQ(toText(needsFrom(toText(needs), solution)), toText(needs));
    Needs const again = needsOf(runs, needs.least, 600); // nothing to leave out
    EXPECT_EQ(again.frame, needs.leastFrame);
    EXPECT_EQ(again.leastFrame, needs.leastFrame);
}

TEST(Needs, OfEachRecordedSolutionCannotBeReducedFurther) {
    for (char const* const name : {"2-electricity/1-both-gaps.json", "2-electricity/3-two-buttons.json"}) {
        LevelUnderTest const level(gameData(), testedFile(name));
        LevelRuns const runs(gameData(), level.level());
        for (Solution const& solution : level.level().solutions) {
            std::uint64_t const frames = LevelRuns::framesFor(solution);
            Needs const needs = needsOf(runs, solution, frames);
            EXPECT_EQ(needs.solves, solution.solves) << name << ", " << solution.name;
            if (!needs.solves) {
                continue;
            }
            EXPECT_TRUE(runs.run({needs.least, {}}, {.frames = frames}).solved);
            for (std::size_t i = 0; i < needs.least.placements.size(); ++i) {
                EXPECT_FALSE(runs.run({needs.least, {withoutPlacement(i)}}, {.frames = frames}).solved)
                    << name << ", " << solution.name << " without " << needs.least.placements[i].part;
            }
        }
    }
}

TEST(Deeds, AreGesturesByHand) {
    Solution solution;
    auto const add = [&](std::uint64_t frame, PlayerInput::Kind kind, char const* object, int hand) {
        RecordedInput input;
        input.frame = frame;
        input.kind = kind;
        input.object = object;
        input.hand = hand;
        solution.inputs.push_back(input);
    };
    using Kind = PlayerInput::Kind;
    add(1, Kind::grab, "a", 0);
    add(2, Kind::grab, "b", 1);
    add(3, Kind::move, "", 0);
    add(4, Kind::move, "", 1);
    add(5, Kind::release, "", 0);
    add(6, Kind::remove, "c", 0);
    add(7, Kind::release, "", 1);
    std::vector<Deed> const deeds = deedsOf(solution);
    ASSERT_EQ(deeds.size(), 3U);
    EXPECT_EQ(deeds[0].what, "grab a");
    EXPECT_EQ(deeds[0].inputs, (std::vector<std::size_t>{0, 2, 4}));
    EXPECT_EQ(deeds[1].inputs, (std::vector<std::size_t>{1, 3, 6}));
    EXPECT_EQ(deeds[2].what, "remove c");
}

} // namespace
} // namespace trembler::insight
