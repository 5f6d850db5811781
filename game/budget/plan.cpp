#include "game/budget/plan.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace trembler::budget {
namespace {

struct Combination {
    double cost = 0;
    double error = 0;
    std::vector<std::size_t> choices;
};

/// Keeps the Pareto front, ascending by cost: drops combinations that another one equals or beats in both
/// cost and error.
void keepFront(std::vector<Combination>& all) {
    std::stable_sort(all.begin(), all.end(), [](Combination const& a, Combination const& b) {
        return a.cost != b.cost ? a.cost < b.cost : a.error < b.error;
    });
    double least = std::numeric_limits<double>::infinity();
    std::erase_if(all, [&](Combination const& one) {
        bool const beaten = one.error >= least;
        least = std::min(least, one.error);
        return beaten;
    });
}

} // namespace

std::vector<std::size_t> bestPlan(std::span<std::vector<Choice> const> knobs, double budget) {
    std::vector<Combination> front(1);
    for (std::vector<Choice> const& choices : knobs) {
        bool const any =
            std::any_of(choices.begin(), choices.end(), [](Choice const& c) { return c.allowed; });
        std::vector<Combination> longer;
        for (Combination const& so : front) {
            for (std::size_t i = 0; i < choices.size(); ++i) {
                if (choices[i].allowed || !any) {
                    Combination next{so.cost + choices[i].cost, so.error + choices[i].error, so.choices};
                    next.choices.push_back(i);
                    longer.push_back(std::move(next));
                }
            }
        }
        keepFront(longer);
        // Further knobs only add cost, so combinations over the budget are dropped, except for the cheapest,
        // which is the answer if nothing fits.
        auto const tooExpensive = std::find_if(longer.begin() + 1, longer.end(),
                                               [&](Combination const& c) { return c.cost > budget; });
        longer.erase(tooExpensive, longer.end());
        front = std::move(longer);
    }
    // Ascending by cost and falling by error: the most expensive combination that fits has the least error.
    return front.back().cost <= budget ? front.back().choices : front.front().choices;
}

} // namespace trembler::budget
