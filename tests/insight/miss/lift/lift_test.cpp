// The lift that a liquid lacks, compared with Archimedes' principle by hand.
#include "insight/miss/lift/lift.hpp"
#include "physics/depth.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/explained_miss.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::insight {
namespace lift_tests {
namespace {

constexpr double gravity = 9.81;

/// A basin of water up to y = 0, a plank in it that a goal requires higher, and objects on the plank.
LevelFile basin(double density, std::string const& more = "", std::string const& area = "[-9, 0.2, 18, 2]",
                std::string const& goal = "") {
    std::string const text = R"({"version": 2, "title": "Basin",
  "world": {"gravity": [0, -9.81], "bounds": [-10, -5, 20, 10]},
  "objects": [
    {"name": "water", "at": [0, -2],
     "properties": {"shape": [{"form": "box", "width": 16, "height": 4}], "density": 1000, "liquid": {}}},
    {"name": "plank", "at": [0, -1],
     "properties": {"shape": [{"form": "box", "width": 2, "height": 0.2}], "density": )" +
                             std::to_string(density) + "}}" + more + R"(],
  "goals": {"inside": {"object": "plank", "area": )" +
                             area + R"(}, "id": "up")" + goal + "}}";
    return readLevel(gameData().registry, JsonDocument::parse(text, "basin.json"));
}

/// The explained miss of a run of that many frames.
Miss missIn(LevelFile const& level, std::uint64_t frames = 1) {
    return explainedMiss(level, frames);
}

Miss const* lackIn(Miss const& miss, Lack lack) {
    auto const at = std::find_if(miss.besides.begin(), miss.besides.end(),
                                 [&](Miss const& other) { return other.lack == lack; });
    return at == miss.besides.end() ? nullptr : &*at;
}

TEST(Lift, OfAPlankThatShouldLieHigherIsWhatItWouldDisplaceThere) {
    // With its centre there, half of its height of 0.2 m would be in the water.
    Miss const miss = missIn(basin(800, "", "[-9, 0, 18, 2]"));
    ASSERT_EQ(miss.lack, Lack::distance);
    Miss const* const lift = lackIn(miss, Lack::lift);
    ASSERT_NE(lift, nullptr);
    double const weight = 800 * 2 * 0.2 * worldDepth * gravity;
    double const lifted = 1000 * 2 * 0.1 * worldDepth * gravity;
    EXPECT_NEAR(lift->by, weight - lifted, 0.01 * weight);
    EXPECT_EQ(lift->names, (std::vector<std::string>{"water", "plank"}));
    EXPECT_EQ(lackIn(miss, Lack::torque), nullptr) << "nothing lies on it";
}

TEST(Lift, IsNotMissingForWhatFloatsHighEnough) {
    Miss const miss = missIn(basin(200, "", "[-9, 0, 18, 2]"));
    ASSERT_EQ(miss.lack, Lack::distance);
    EXPECT_TRUE(miss.besides.empty());
}

TEST(Lift, IsNotAskedOfALiquidThatDoesNotReachThere) {
    Miss const miss = missIn(basin(2000, "", "[-9, 0.5, 18, 2]"));
    ASSERT_EQ(miss.lack, Lack::distance);
    EXPECT_TRUE(miss.besides.empty());
}

// In the frame in which it leaves the area, it is less than a millimetre below it.
TEST(Lift, OfWhatSinksSlowlyIsToldOfTheMomentAtWhichItBeganTo) {
    constexpr double density = 1020;
    constexpr double deep = 1e-3; // m that it may sink
    LevelFile const level = basin(density, "", "[-9, -1.001, 18, 2]", R"(, "for": 5)");
    Miss const miss = missIn(level, 240);
    ASSERT_EQ(miss.lack, Lack::time);
    ASSERT_EQ(miss.besides.size(), 1U);
    Miss const& sunk = miss.besides.front();
    EXPECT_EQ(sunk.lack, Lack::distance);
    Miss const* const lift = lackIn(sunk, Lack::lift);
    ASSERT_NE(lift, nullptr);
    double const missing = (density - 1000) * 2 * 0.2 * worldDepth * gravity;
    EXPECT_NEAR(lift->by, missing, 0.01 * missing);
    // It falls freely at most, under the lift that it lacks: in the frames before that moment by less than it
    // may sink.
    EXPECT_LT(lift->frame, sunk.frame);
    double const time = static_cast<double>(lift->frame) * frameDuration;
    EXPECT_GT(missing / (density * 2 * 0.2 * worldDepth) / 2 * time * time, 0.8 * deep);
    EXPECT_LT(time, 1);
    // Explained frame by frame: when the goal ended, less than a millimetre was missing.
    Miss const then = missIn(level, lift->frame);
    ASSERT_EQ(then.besides.size(), 1U);
    EXPECT_LT(then.besides.front().by, deep);
    EXPECT_NE(lackIn(then.besides.front(), Lack::lift), nullptr);
}

TEST(Lift, BearsWhatLiesOnItAndIsTurnedByIt) {
    // A stone of 0.2 m by 0.2 m, 0.8 m left of the middle, and one on top of it.
    std::string const stone = R"("properties": {"shape": [{"form": "box", "width": 0.2, "height": 0.2}], )"
                              R"("density": 3000}})";
    Miss const miss = missIn(basin(700,
                                   R"(, {"name": "stone", "at": [-0.8, -0.8], )" + stone +
                                       R"(, {"name": "top", "at": [-0.8, -0.6], )" + stone,
                                   "[-9, -0.97, 18, 2]"),
                             2); // a contact is known after a frame
    ASSERT_EQ(miss.lack, Lack::distance);
    double const weight = 700 * 2 * 0.2 * worldDepth * gravity;
    double const lifted = 1000 * 2 * 0.2 * worldDepth * gravity;
    double const load = 2 * (3000 - 1000) * 0.2 * 0.2 * worldDepth * gravity; // stones displace water
    Miss const* const lift = lackIn(miss, Lack::lift);
    ASSERT_NE(lift, nullptr);
    EXPECT_NEAR(lift->by, weight + load - lifted, 1);
    Miss const* const torque = lackIn(miss, Lack::torque);
    ASSERT_NE(torque, nullptr);
    EXPECT_NEAR(torque->by, load * 0.8, 0.05 * load); // its own lift acts in the middle
    EXPECT_EQ(torque->names, (std::vector<std::string>{"water", "plank", "stone", "top"}));
}

} // namespace
} // namespace lift_tests
} // namespace trembler::insight
