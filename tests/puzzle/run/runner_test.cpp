// Running a session: frames that take long are reported.
#include "puzzle/run/runner.hpp"
#include "tests/support/experiment.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace trembler {
namespace runner_test {
namespace {

class Runner : public Experiment {};

TEST_F(Runner, TellsOfFramesThatTakeMoreProcessorTimeThanStated) {
    open("1-switched-electromagnet.json");
    RunOptions options;
    options.frames = 5;
    std::vector<std::uint64_t> told;
    options.slow = [&](World const& world, std::uint64_t frame, double seconds) {
        EXPECT_EQ(world.frame(), frame);
        EXPECT_GE(seconds, 0);
        told.push_back(frame);
    };
    options.slowAfter = -1; // each frame takes longer
    std::uint64_t const hash = run(session(), "", options).stateHash;
    EXPECT_EQ(told, (std::vector<std::uint64_t>{1, 2, 3, 4, 5}));
    options.slowAfter = 1e9;
    told.clear();
    EXPECT_EQ(run(session(), "", options).stateHash, hash);
    EXPECT_TRUE(told.empty());
}

} // namespace
} // namespace runner_test
} // namespace trembler
