#include "insight/search/recorded.hpp"
#include "insight/trial/trial.hpp"
#include "tests/insight/support/on_threads.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace {

TEST(RecordedKinds, AreThoseOfTheSolutionsThatSolveTheLevel) {
    Workers workers(onThreads(2));
    std::vector<RecordedKind> const recorded = recordedKinds(firstContact(), workers);
    ASSERT_EQ(recorded.size(), 2U) << "the third one is recorded as a run that does not";
    EXPECT_EQ(recorded[0].name, firstContact().level().solutions[0].name);
    EXPECT_TRUE(differ(recorded[0].graph, recorded[1].graph));
    FoundSolution found;
    found.graph = recorded[1].graph;
    EXPECT_EQ(recordedAs(recorded, found), recorded[1].name);
    found.graph.deeds.insert("cut");
    EXPECT_EQ(recordedAs(recorded, found), "");
}

TEST(KeptSolution, IsNamedByWhatItNeedsAndLastsASecondLonger) {
    FoundSolution found;
    found.needs.least = placing("steel bar", {0, 1});
    found.needs.parts = {"steel bar"};
    found.needs.deeds = {"grab crate"};
    found.needs.frame = 25; // of the solution from which parts were left out
    found.needs.leastFrame = 40;
    Solution const kept = keptSolution(found, 2);
    EXPECT_EQ(kept.name, "found 2: steel bar, grab crate");
    EXPECT_EQ(kept.frames, 100);
    EXPECT_EQ(kept.placements.size(), 1U);
}

} // namespace
} // namespace trembler::insight
