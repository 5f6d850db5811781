// What the time budget decided during a run, as `trembler run --budget` tells it.
#pragma once

#include "game/budget/budget_mode.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace trembler {

/// Adds the member "budget": the decisions with frame, effect, levels, time saved (us) and error, and whether
/// the budget was kept.
void addBudget(nlohmann::ordered_json& all, budget::BudgetMode const& mode);

/// The same as lines for people.
[[nodiscard]] std::string budgetInWords(budget::BudgetMode const& mode);

} // namespace trembler
