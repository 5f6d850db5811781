// The best combination of choices that a budget allows: a multiple-choice knapsack.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace trembler::budget {

struct Choice {
    double cost = 0;  ///< µs
    double error = 0; ///< errors of different knobs add up
    bool allowed = true;
};

/// For each knob the index of the choice to make: of the combinations of allowed choices that cost `budget`
/// (µs) at most, one with the least error, and of these the cheapest. If none is so cheap: the cheapest, and
/// of these one with the least error. Where a knob allows nothing, all of its choices count as allowed. No
/// knob may be without choices. Exact; the same choices always give the same plan.
///
/// Combinations that another one beats in both respects are dropped knob by knob (Nemhauser and Ullmann
/// 1969), so that what is left is the Pareto front: in practice tens, in the worst case all combinations.
[[nodiscard]] std::vector<std::size_t> bestPlan(std::span<std::vector<Choice> const> knobs, double budget);

} // namespace trembler::budget
