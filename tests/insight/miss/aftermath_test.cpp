#include "insight/miss/aftermath.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/explained_miss.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler::insight {
namespace aftermath_tests {
namespace {

/// A ball falls from y = 1 through areas in which it should stay.
LevelFile fall(std::string const& goals) {
    std::string const text = R"({"version": 2, "title": "Fall",
  "world": {"gravity": [0, -9.81], "bounds": [-10, -50, 20, 60]},
  "objects": [
    {"name": "ball", "at": [0, 1],
     "properties": {"shape": [{"form": "circle", "radius": 0.1}], "density": 1000}}],
  "goals": )" + goals + "}";
    return readLevel(gameData().registry, JsonDocument::parse(text, "fall.json"));
}

std::string inside(double floor, std::string const& more = "") {
    return R"({"inside": {"object": "ball", "area": [-5, )" + std::to_string(floor) + R"(, 10, 10]})" + more +
           "}";
}

/// How far the ball has fallen by a frame, m.
double fallen(std::uint64_t frame) {
    double const time = static_cast<double>(frame) * frameDuration;
    return 9.81 / 2 * time * time;
}

TEST(Aftermath, TellsHowFarWhatHeldWentAstrayInTheTimeForWhichItShouldHaveHeld) {
    Miss const miss = explainedMiss(fall(inside(0.5, R"(, "for": 1)")), 600);
    ASSERT_EQ(miss.lack, Lack::time);
    ASSERT_EQ(miss.besides.size(), 1U);
    Miss const& ended = miss.besides.front();
    EXPECT_EQ(ended.lack, Lack::distance);
    EXPECT_EQ(ended.names, std::vector<std::string>{"ball"});
    // One second after it began to hold, in the first frame.
    EXPECT_NEAR(static_cast<double>(ended.frame), 60, 2);
    double const frameLong = 9.81 * frameDuration; // m per frame at that time: one frame more or less
    EXPECT_NEAR(ended.by, fallen(ended.frame) - 0.5, frameLong);
}

TEST(Aftermath, TellsThePartsInTheOrderInWhichTheyCeasedToHold) {
    Miss const miss =
        explainedMiss(fall(R"({"all": [)" + inside(0) + ", " + inside(0.5) + R"(], "for": 3})"), 600);
    ASSERT_EQ(miss.lack, Lack::time);
    ASSERT_EQ(miss.besides.size(), 2U);
    EXPECT_NEAR(miss.besides[0].to.y, 0.5, 1e-9);
    EXPECT_NEAR(miss.besides[1].to.y, 0, 1e-9);
}

TEST(Aftermath, WhatStillHoldsAtTheEndIsMissingTimeOnly) {
    Miss const miss = explainedMiss(fall(inside(0.5, R"(, "for": 1)")), 10);
    EXPECT_EQ(miss.lack, Lack::time);
    EXPECT_TRUE(miss.besides.empty());
}

// Three boxes touch the raft at the same time for a frame, bounce, and slide off a second later.
TEST(Aftermath, ABounceIsNotWhatEndedIt) {
    LevelFile const level = loadLevel(gameData().registry, testedFile("experiments/4-raft.json"));
    Miss const miss = explainedMiss(level, 1800, {*level.findSolution("load the left end")});
    ASSERT_EQ(miss.lack, Lack::time);
    ASSERT_EQ(miss.besides.size(), 2U);
    EXPECT_EQ(miss.besides.front().lack, Lack::distance);
    EXPECT_EQ(miss.besides.front().names.front(), "raft body");
    EXPECT_EQ(miss.besides.back().lack, Lack::count);
}

} // namespace
} // namespace aftermath_tests
} // namespace trembler::insight
