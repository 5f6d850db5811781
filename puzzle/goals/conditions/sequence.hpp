// How far a condition of the kind "sequence" has come.
#pragma once

#include "puzzle/goals/judging/condition_state.hpp"

#include <cstddef>
#include <optional>

namespace trembler::conditions {

/// How many of its steps were met, each in its turn. Throws std::bad_any_cast for a condition of another
/// kind.
[[nodiscard]] std::size_t stepsDone(ConditionState const& state);
/// The same of a condition of any kind: nothing if it is no sequence.
[[nodiscard]] std::optional<std::size_t> stepsDoneIfAny(ConditionState const& state);

} // namespace trembler::conditions
