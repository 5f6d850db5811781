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
    options.slow = [&](SlowFrame const& slow) {
        EXPECT_EQ(slow.seconds, 1.5);
        told.push_back(slow.frame);
    };
    double now = 0; // between two readings 1.5 s pass
    options.timer = FrameTimer(1, [&] { return now += 1.5; });
    std::uint64_t const hash = run(session(), "", options).stateHash;
    EXPECT_EQ(told, (std::vector<std::uint64_t>{1, 2, 3, 4, 5}));
    options.timer = FrameTimer(2, [&] { return now += 1.5; });
    told.clear();
    EXPECT_EQ(run(session(), "", options).stateHash, hash);
    EXPECT_TRUE(told.empty());
}

} // namespace
} // namespace runner_test
} // namespace trembler
