#include "insight/kind/cause_graph.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace {

CauseGraph graphOf(std::string const& solution) {
    LevelRuns const runs(gameData(), firstContact().level());
    return causeGraphOf(runs, *firstContact().level().findSolution(solution), 600);
}

TEST(CauseGraph, IsThatOfTheChainOfCauses) {
    CauseGraph const bar = graphOf("the steel bar");
    ASSERT_TRUE(bar.solves);
    EXPECT_EQ(bar.parts, std::set<std::string>{"steel bar"});
    EXPECT_TRUE(bar.deeds.empty());
    bool connects = false;
    for (auto const& [cause, effect] : bar.links) {
        EXPECT_NE(cause, effect);
        connects = connects || cause.find("Electricity <- Dynamics") != std::string::npos ||
                   effect.find("Electricity <- Dynamics") != std::string::npos;
    }
    EXPECT_TRUE(connects) << "the contacts of the bar close the circuit: " << toText(bar);
    EXPECT_EQ(causeGraphFrom(toText(bar)), bar);
    EXPECT_TRUE(inWords(bar).starts_with("steel bar; ")) << inWords(bar);
    CauseGraph const wood = graphOf("the wooden bar");
    EXPECT_FALSE(wood.solves);
    EXPECT_TRUE(wood.links.empty());
}

TEST(CauseGraph, DiffersByPartsDeedsAndLinksNotByPlaces) {
    CauseGraph const bar = graphOf("the steel bar");
    LevelRuns const runs(gameData(), firstContact().level());
    EXPECT_FALSE(differ(bar, causeGraphOf(runs, placing("steel bar", {-1.75, 1.2}), 600)));
    CauseGraph other = bar;
    other.parts = {"spanner"};
    EXPECT_TRUE(differ(bar, other));
    other.parts = {"spanner", "steel bar"};
    EXPECT_FALSE(differ(bar, other)) << "a part that was merely added";
    other = bar;
    other.deeds = {"grab"};
    EXPECT_TRUE(differ(bar, other));
    other = bar;
    other.links.erase(other.links.begin());
    EXPECT_TRUE(differ(bar, other));
}

} // namespace
} // namespace trembler::insight
