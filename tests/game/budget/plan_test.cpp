// The knapsack solution compared with all combinations.
#include "game/budget/plan.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <optional>
#include <utility>
#include <vector>

namespace trembler::budget {
namespace {

struct Sum {
    double cost = 0;
    double error = 0;
};

Sum sumOf(std::vector<std::vector<Choice>> const& knobs, std::vector<std::size_t> const& plan) {
    Sum sum;
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        sum.cost += knobs[i][plan[i]].cost;
        sum.error += knobs[i][plan[i]].error;
    }
    return sum;
}

/// The same by trying all combinations.
Sum bruteForce(std::vector<std::vector<Choice>> const& knobs, double budget) {
    std::vector<std::size_t> plan(knobs.size(), 0);
    std::optional<Sum> best;
    std::optional<Sum> cheapest;
    for (;;) {
        bool allowed = true;
        for (std::size_t i = 0; i < knobs.size(); ++i) {
            allowed = allowed && knobs[i][plan[i]].allowed;
        }
        if (allowed) {
            Sum const sum = sumOf(knobs, plan);
            if (sum.cost <= budget &&
                (!best || std::pair(sum.error, sum.cost) < std::pair(best->error, best->cost))) {
                best = sum;
            }
            if (!cheapest || std::pair(sum.cost, sum.error) < std::pair(cheapest->cost, cheapest->error)) {
                cheapest = sum;
            }
        }
        std::size_t at = 0;
        while (at < plan.size() && ++plan[at] == knobs[at].size()) {
            plan[at++] = 0;
        }
        if (at == plan.size()) {
            return best ? *best : cheapest.value_or(Sum{});
        }
    }
}

// Quarters add up without rounding, so that equal means equal.
double quarters(int most) {
    return *rc::gen::inRange(0, most) / 4.0;
}

std::vector<std::vector<Choice>> someKnobs() {
    std::vector<std::vector<Choice>> knobs(static_cast<std::size_t>(*rc::gen::inRange(1, 5)));
    for (auto& choices : knobs) {
        choices.resize(static_cast<std::size_t>(*rc::gen::inRange(1, 6)));
        for (Choice& choice : choices) {
            choice = {quarters(80), quarters(80), *rc::gen::inRange(0, 5) > 0};
        }
        choices.front().allowed = true;
    }
    return knobs;
}

TEST(BudgetPlan, IsTheBestOfAllCombinations) {
    EXPECT_TRUE(rc::check([] {
        auto const knobs = someKnobs();
        double const budget = quarters(240);
        std::vector<std::size_t> const plan = bestPlan(knobs, budget);
        RC_ASSERT(plan.size() == knobs.size());
        for (std::size_t i = 0; i < plan.size(); ++i) {
            RC_ASSERT(knobs[i][plan[i]].allowed);
        }
        Sum const found = sumOf(knobs, plan);
        Sum const right = bruteForce(knobs, budget);
        RC_ASSERT(found.cost == right.cost);
        RC_ASSERT(found.error == right.error);
    }));
}

TEST(BudgetPlan, IsEmptyWithoutKnobsAndUsesAnyOptionIfNoneIsAllowed) {
    EXPECT_TRUE(bestPlan({}, 1).empty());
    std::vector<std::vector<Choice>> const forbidden{{{2, 1, false}, {1, 2, false}}};
    EXPECT_EQ(bestPlan(forbidden, 5), std::vector<std::size_t>{0})
        << "if no option is allowed, all are considered";
}

} // namespace
} // namespace trembler::budget
