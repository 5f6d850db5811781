// What magnets do in answers: which of them is told, and how well it is known.
#include "insight/why/answer.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::insight {
namespace why_pulls {
namespace {

Answer answerIn(std::string const& name, std::string const& solution) {
    LevelFile const level = loadLevel(gameData().registry, gameData().home / "levels" / (name + ".json"));
    LevelRuns const runs(gameData(), level);
    Solution const& asked = *level.findSolution(solution);
    AskOptions options;
    options.frames = LevelRuns::framesFor(asked);
    return why(runs, asked, {}, options);
}

ChainStep const* pullIn(Answer const& answer, std::string const& object, std::string const& magnet) {
    auto const at = std::find_if(answer.chain.begin(), answer.chain.end(), [&](ChainStep const& one) {
        return one.step.kind == StepKind::pull && one.step.objects == std::vector{object, magnet};
    });
    return at == answer.chain.end() ? nullptr : &*at;
}

// A placed magnet is told with what it pulls, and a run without it confirms the pull.
TEST(WhyPulls, APlacedMagnetPullsBecauseItWasPlaced) {
    Answer const answer = answerIn("3-magnets/4-two-needles", "one magnet, turned round");
    ASSERT_TRUE(answer.happened);
    ChainStep const* const pull = pullIn(answer, "left needle", "small magnet 1");
    ASSERT_NE(pull, nullptr);
    EXPECT_EQ(pull->proof, Proof::confirmed);
    ASSERT_EQ(pull->step.because.size(), 1U);
    EXPECT_EQ(answer.chain[pull->step.because.front()].step.kind, StepKind::placed);
}

// A small magnet that holds a relay also pulls the door, with a third of the door magnet's force.
TEST(WhyPulls, EachOfTwoMagnetsIsTold) {
    Answer const answer =
        answerIn("5-everything/5-two-yes-one-no", "two weights, and a magnet for the relay");
    ASSERT_TRUE(answer.happened);
    for (char const* const magnet : {"small magnet 1", "door magnet"}) {
        ChainStep const* const pull = pullIn(answer, "safe door", magnet);
        ASSERT_NE(pull, nullptr) << magnet;
        EXPECT_EQ(pull->proof, Proof::confirmed) << magnet;
    }
    EXPECT_EQ(pullIn(answer, "safe door", "relay coil"), nullptr) << "its force is far weaker";
}

// Without its coil the alarm would have been silent after the cut as well; but the coil is why its tongue
// left the contact before, so it is told, and not said to be confirmed.
TEST(WhyPulls, WhatPartedTwoObjectsIsToldAsTraced) {
    Answer const answer = answerIn("5-everything/3-the-quiet-gate", "cut off the alarm");
    ASSERT_TRUE(answer.happened);
    ChainStep const* const pull = pullIn(answer, "alarm tongue", "alarm coil");
    ASSERT_NE(pull, nullptr);
    EXPECT_EQ(pull->proof, Proof::traced);
}

} // namespace
} // namespace why_pulls
} // namespace trembler::insight
