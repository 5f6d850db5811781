// The decisions of the time budget during a run, as reported by `trembler run --budget`.
#pragma once

#include "game/budget/budget_mode.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace trembler {

/// Adds the member "budget": every decision with its frame, effect, options, time saved (µs per frame) and
/// error, and whether the budget was kept.
void addBudget(nlohmann::ordered_json& all, budget::BudgetMode const& mode);

/// The same report as lines of text for people.
[[nodiscard]] std::string budgetInWords(budget::BudgetMode const& mode);

} // namespace trembler
