// How far a condition of the kind "sequence" has come.
#pragma once

#include "puzzle/goals/judging/condition_state.hpp"

namespace trembler::conditions {

/// How many of its steps were met, each in its turn. Throws std::bad_any_cast for a condition of another
/// kind.
[[nodiscard]] std::size_t stepsDone(ConditionState const& state);

} // namespace trembler::conditions
