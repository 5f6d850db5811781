// Attempts that the search makes from nothing and from nearest misses.
#include "insight/search/mutation.hpp"
#include "insight/trial/solution_text.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace mutation_tests {
namespace {

constexpr std::uint64_t attempts = 60;

Parent emptyParent() {
    TrialResult const result = tryOut(firstContact(), {}, {.frames = 60, .measureMiss = true});
    return {{}, result.miss, 1, result.lacking};
}

TEST(Mutation, CombinesOneToFourPartsThatFit) {
    Mutator const mutator(firstContact(), false);
    std::set<std::size_t> numbers;
    for (std::uint64_t n = 0; n < attempts; ++n) {
        CounterRandom random(keyOf(1, {"combined"}, n));
        Solution const solution = mutator.combined(random);
        EXPECT_EQ(whyNotPlaced(firstContact(), solution), std::nullopt);
        EXPECT_LE(solution.placements.size(), 4U);
        numbers.insert(solution.placements.size());
        CounterRandom again(keyOf(1, {"combined"}, n));
        EXPECT_EQ(identityOf(mutator.combined(again)), identityOf(solution));
    }
    EXPECT_GE(numbers.size(), 2U);
}

TEST(Mutation, MakesNothingThatWasTried) {
    Mutator const mutator(firstContact(), false);
    std::vector<Parent> const parents{emptyParent()};
    Tried tried{identityOf({})};
    for (std::uint64_t n = 0; n < attempts; ++n) {
        CounterRandom random(keyOf(1, {"changed"}, n));
        Attempt const attempt = mutator.changed(parents, tried, random);
        EXPECT_EQ(whyNotPlaced(firstContact(), attempt.solution), std::nullopt);
        if (attempt.parent != 0) {
            EXPECT_EQ(attempt.parent, 1U);
            EXPECT_TRUE(tried.insert(identityOf(attempt.solution)).second);
        }
    }
    EXPECT_GT(tried.size(), attempts / 2);
}

// The nearest miss of the empty toolbox names the gap: a part that conducts is soon laid across it.
TEST(Mutation, AddsPartsWhereSomethingWasLacking) {
    Mutator const mutator(firstContact(), false);
    auto const solvedOf = [&](Parent const& parent) {
        std::uint64_t solved = 0;
        for (std::uint64_t n = 0; n < attempts; ++n) {
            CounterRandom random(keyOf(1, {"lacking"}, n));
            Solution const made = mutator.changed({&parent, 1}, {}, random).solution;
            solved += tryOut(firstContact(), made, {.frames = 600}).solved ? 1 : 0;
        }
        return solved;
    };
    Parent const told = emptyParent();
    ASSERT_FALSE(told.lacking.empty());
    Parent untold = told;
    untold.lacking.clear();
    EXPECT_GT(solvedOf(told), solvedOf(untold));
}

} // namespace
} // namespace mutation_tests
} // namespace trembler::insight
