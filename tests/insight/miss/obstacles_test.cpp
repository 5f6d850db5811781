// Magnets as the reasons why an object did not reach its goal.
#include "insight/miss/obstacles.hpp"
#include "insight/why/words/words.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/explained_miss.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::insight {
namespace obstacles_test {
namespace {

std::vector<std::string> toldIn(std::string const& file, Solution const& solution,
                                AnswerLanguage const& language = AnswerLanguage()) {
    LevelFile const level = loadLevel(gameData().registry, testedFile(file));
    std::uint64_t const frames = solution.frames ? LevelRuns::framesFor(solution) : 300;
    return sentencesOf(explainedMiss(level, frames, {solution}), language);
}

std::vector<std::string> toldIn(std::string const& file, std::string const& solution,
                                AnswerLanguage const& language = AnswerLanguage()) {
    LevelFile const level = loadLevel(gameData().registry, testedFile(file));
    return toldIn(file, *level.findSolution(solution), language);
}

bool says(std::vector<std::string> const& sentences, std::string const& words) {
    return std::any_of(sentences.begin(), sentences.end(), [&](std::string const& sentence) {
        return sentence.find(words) != std::string::npos;
    });
}

// The gap is at the relay's armature, and its coil has no current.
TEST(Obstacles, TheCoilOfARelayIsNamedWithItsGap) {
    auto const told = toldIn("2-electricity/5-small-and-large.json", "the relay is at rest");
    EXPECT_TRUE(says(told, "between the relay armature and the relay lower")) << told.front();
    ASSERT_EQ(told.size(), 2U);
    EXPECT_TRUE(says(told, "No current flowed through the relay coil")) << told.back();
}

// Only the magnet would have to release its object.
TEST(Obstacles, AMagnetThatHoldsIsNamed) {
    auto const told = toldIn("3-magnets/6-the-crane.json", "the block is never let go");
    EXPECT_TRUE(says(told, "The crane magnet still held the iron block back")) << told.back();
    Catalogue const german(gameData().home / "assets" / "text", "de");
    auto const german2 =
        toldIn("3-magnets/6-the-crane.json", "the block is never let go", AnswerLanguage(german));
    EXPECT_TRUE(says(german2, " noch zurück")) << german2.back();
}

// The coil of a relay is nearer to the safe's door than the magnet that lifts it.
TEST(Obstacles, TheMagnetThatWouldPullMostIsNamed) {
    auto const told = toldIn("5-everything/5-two-yes-one-no.json", Solution{});
    EXPECT_TRUE(says(told, "No current flowed through the door magnet")) << told.back();
    EXPECT_FALSE(says(told, "relay coil:")) << told.back();
}

TEST(Obstacles, WhatIsNotThereIsSaidToBeMissing) {
    auto const told = toldIn("3-magnets/5-a-bell-for-the-door.json", "no bell");
    EXPECT_TRUE(says(told, "nothing that the striker could have touched")) << told.front();
}

} // namespace
} // namespace obstacles_test
} // namespace trembler::insight
