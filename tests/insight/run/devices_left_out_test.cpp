#include "insight/run/devices_left_out.hpp"
#include "insight/run/level_runs.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace devices_left_out_test {
namespace {

// The coil gets its current, but lifts nothing.
TEST(DevicesLeftOut, AMagnetThatIsStilledPullsNothing) {
    LevelFile const level =
        loadLevel(gameData().registry, testedFile("experiments/1-switched-electromagnet.json"));
    LevelRuns const runs(gameData(), level);
    EXPECT_TRUE(runs.run({}, {.frames = 300}).solved);
    EXPECT_FALSE(runs.run({{}, {withoutDevice("electromagnet", 1)}}, {.frames = 300}).solved);
}

// A motor without torque leaves the gate where it is, while a current flows through it.
TEST(DevicesLeftOut, AMotorThatIsStilledTurnsNothing) {
    LevelFile const level = loadLevel(gameData().registry, testedFile("5-everything/2-the-gate.json"));
    LevelRuns const runs(gameData(), level);
    Solution const& solution = *level.findSolution("mend the wire");
    RunLimits const limits{.frames = LevelRuns::framesFor(solution)};
    EXPECT_TRUE(runs.run({solution}, limits).solved);
    EXPECT_FALSE(runs.run({solution, {withoutDevice("gate", 1)}}, limits).solved);
}

// A magnet holds the laboratory's door: if the magnet is not switched, it holds the door for ever.
TEST(DevicesLeftOut, AMagnetThatIsNotSwitchedStaysOn) {
    LevelFile const level =
        loadLevel(gameData().registry, testedFile("5-everything/1-the-laboratory-door.json"));
    LevelRuns const runs(gameData(), level);
    Solution const& solution = *level.findSolution("pull the main fuse");
    RunLimits const limits{.frames = LevelRuns::framesFor(solution)};
    EXPECT_TRUE(runs.run({solution}, limits).solved);
    EXPECT_FALSE(runs.run({solution, {withoutSwitching("door magnet", 5)}}, limits).solved);
}

// Before the frame from which a device is missing nothing differs; and an unknown name has no effect.
TEST(DevicesLeftOut, BeginToBeMissingInTheStatedFrame) {
    LevelFile const level =
        loadLevel(gameData().registry, testedFile("experiments/1-switched-electromagnet.json"));
    LevelRuns const runs(gameData(), level);
    std::uint64_t const whole = runs.run({}, {.frames = 40}).stateHash;
    EXPECT_EQ(runs.run({{}, {withoutDevice("electromagnet", 41)}}, {.frames = 40}).stateHash, whole);
    EXPECT_EQ(runs.run({{}, {withoutDevice("no such thing", 1)}}, {.frames = 40}).stateHash, whole);
}

} // namespace
} // namespace devices_left_out_test
} // namespace trembler::insight
