// The answer names the player's actions wherever the level is not solved without them.
#include "insight/why/story/deed_steps.hpp"
#include "insight/why/words/words.hpp"
#include "puzzle/campaign/as_played.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace trembler::insight {
namespace deed_steps {
namespace {

/// The steps by the player's hand that are known to be causes.
std::vector<Step> deedsIn(Answer const& answer) {
    std::vector<Step> deeds;
    for (ChainStep const& one : answer.chain) {
        if (isDeed(one.step.kind) && (one.proof == Proof::confirmed || one.proof == Proof::together)) {
            deeds.push_back(one.step);
        }
    }
    return deeds;
}

std::string words(Answer const& answer) {
    std::string all;
    for (std::string const& sentence : sentencesOf(answer, answer.goal, AnswerLanguage())) {
        all += sentence + " ";
    }
    return all;
}

struct Count {
    int met = 0;      ///< goals that recorded solutions meet
    int byItself = 0; ///< of them, those met without the player by that frame
    int named = 0;    ///< of the others, those whose answer names an action of the player
};

/// Asks of every recorded solution that solves the level why each goal is met.
Count askAll(std::filesystem::path const& file) {
    GameData const& data = gameData();
    LevelFile const level = asPlayed(loadLevel(data.registry, file), "");
    LevelRuns const runs(data, level);
    Count count;
    for (Solution const& solution : level.solutions) {
        RunResult const whole = runs.run({solution}, {.frames = LevelRuns::framesFor(solution)});
        for (GoalStatus const& goal : whole.goals) {
            if (!goal.frame) {
                continue;
            }
            ++count.met;
            // The time that why() allows.
            std::uint64_t const horizon = *goal.frame + std::max<std::uint64_t>(60, *goal.frame / 4);
            auto const alone = runs.run({}, {.frames = horizon, .stopWhenSolved = false});
            if (std::any_of(alone.goals.begin(), alone.goals.end(),
                            [&](GoalStatus const& other) { return other.id == goal.id && other.frame; })) {
                ++count.byItself;
                continue;
            }
            Question question;
            question.goal = goal.id;
            AskOptions options;
            options.frames = LevelRuns::framesFor(solution);
            Answer const answer = why(runs, solution, question, options);
            bool const named = !deedsIn(answer).empty();
            count.named += named ? 1 : 0;
            EXPECT_TRUE(named) << file.filename() << ", " << solution.name << ", " << goal.id << ": "
                               << words(answer);
        }
    }
    return count;
}

// The laboratory's door: a switch, a fuse that is pulled, a cable that is cut, and an object that is laid
// there; the trace connects none of them with the door.
TEST(DeedSteps, EachWayThroughTheLaboratorysDoorNamesWhatWasDone) {
    Count const count = askAll(testedFile("5-everything/1-the-laboratory-door.json"));
    EXPECT_GE(count.met, 8);
    EXPECT_EQ(count.named, count.met - count.byItself);
}

TEST(DeedSteps, TheGatesWiresAreNamed) {
    LevelFile const level = loadLevel(gameData().registry, testedFile("5-everything/2-the-gate.json"));
    LevelRuns const runs(gameData(), level);
    Answer const answer = why(runs, *level.findSolution("mend the wire"), {});
    ASSERT_TRUE(answer.happened);
    std::vector<Step> const deeds = deedsIn(answer);
    ASSERT_EQ(deeds.size(), 1U) << words(answer);
    EXPECT_EQ(deeds.front().kind, StepKind::wired);
    EXPECT_NE(words(answer).find("you connected "), std::string::npos) << words(answer);
}

// The current that opens the gate also rings an alarm. The alarm is no cause: the gate opens without it.
TEST(DeedSteps, WhatASecondDeviceDoesIsNoCause) {
    LevelFile const level = loadLevel(gameData().registry, testedFile("5-everything/2-the-gate.json"));
    LevelRuns const runs(gameData(), level);
    for (char const* const name : {"any other metal", "the portable generator"}) {
        Solution const& solution = *level.findSolution(name);
        AskOptions options;
        options.frames = LevelRuns::framesFor(solution);
        Answer const answer = why(runs, solution, {}, options);
        ASSERT_TRUE(answer.happened);
        EXPECT_EQ(words(answer).find("alarm"), std::string::npos) << words(answer);
        EXPECT_NE(words(answer).find("current flows through the gate"), std::string::npos) << words(answer);
    }
}

TEST(DeedSteps, BothEndsOfAShortCircuitAreNamed) {
    LevelFile const level =
        loadLevel(gameData().registry, testedFile("5-everything/1-the-laboratory-door.json"));
    LevelRuns const runs(gameData(), level);
    Solution const& solution = *level.findSolution("short-circuit the power plant");
    AskOptions options;
    options.frames = LevelRuns::framesFor(solution);
    Answer const answer = why(runs, solution, {}, options);
    ASSERT_TRUE(answer.happened);
    for (char const* const touch :
         {"left end touches the left busbar", "right end touches the right busbar"}) {
        EXPECT_NE(words(answer).find(touch), std::string::npos) << words(answer);
    }
    EXPECT_NE(words(answer).find("the door magnet ceases to be magnetic"), std::string::npos)
        << words(answer);
}

// The trace does not connect the fall of the block with the wire.
TEST(DeedSteps, ACutWireIsNamed) {
    LevelFile const level = loadLevel(gameData().registry, testedFile("3-magnets/6-the-crane.json"));
    LevelRuns const runs(gameData(), level);
    Solution const& solution = *level.findSolution("cut the wire in time");
    AskOptions options;
    options.frames = LevelRuns::framesFor(solution);
    Answer const answer = why(runs, solution, {}, options);
    ASSERT_TRUE(answer.happened);
    auto const deeds = deedsIn(answer);
    EXPECT_TRUE(std::any_of(deeds.begin(), deeds.end(), [](Step const& step) {
        return step.kind == StepKind::cut;
    })) << words(answer);
    EXPECT_NE(words(answer).find("you cut the wire"), std::string::npos) << words(answer);
}

// All levels of the pack, on request: TREMBLER_ALL_LEVELS=1. Takes many minutes.
TEST(DeedSteps, AreNamedInAllLevels) {
    if (std::getenv("TREMBLER_ALL_LEVELS") == nullptr) { // NOLINT(*-mt-unsafe): one thread
        GTEST_SKIP() << "on request";
    }
    Count all;
    for (std::filesystem::path const& file : gameData().levels()) {
        Count const one = askAll(file);
        all.met += one.met;
        all.byItself += one.byItself;
        all.named += one.named;
    }
    std::cout << all.met << " goals met, " << all.byItself << " of them without the player, " << all.named
              << " answers that name what the player did\n";
    EXPECT_EQ(all.named, all.met - all.byItself);
}

} // namespace
} // namespace deed_steps
} // namespace trembler::insight
