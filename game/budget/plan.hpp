// The best combination of choices that a budget allows: a multiple-choice knapsack.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace trembler::budget {

struct Choice {
    double cost = 0;  ///< µs
    double error = 0; ///< errors of different knobs are added
    bool allowed = true;
};

/// For each knob the index of the chosen option: of the combinations of allowed choices that cost at most
/// `budget` (µs), one with the least error, and of these the cheapest. If none is cheap enough: the cheapest,
/// and of these one with the least error. Where a knob allows none, all of its choices count as allowed.
/// Every knob must have at least one choice. Exact; the same choices always give the same plan.
///
/// Combinations that another one beats in both respects are dropped knob by knob (Nemhauser and Ullmann
/// 1969), so that the Pareto front is left: in practice tens, in the worst case all combinations.
[[nodiscard]] std::vector<std::size_t> bestPlan(std::span<std::vector<Choice> const> knobs, double budget);

} // namespace trembler::budget
