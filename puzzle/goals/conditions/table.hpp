// All kinds of goal conditions.
#pragma once

#include "puzzle/goals/model/condition_kind.hpp"

#include <span>

namespace trembler {

/// Every kind, in the order in which messages list their keys. The kinds live as long as the program.
[[nodiscard]] std::span<ConditionKind const* const> conditionKinds();

} // namespace trembler
