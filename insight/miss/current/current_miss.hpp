// How far objects are from being on, or off.
#pragma once

#include "insight/miss/miss.hpp"
#include "puzzle/goals/judging/condition_state.hpp"

namespace trembler::insight {

/// Of the subjects of a condition, one of which must be on, and none is: the gaps in the circuit of the
/// nearest one; in a closed circuit, the missing power.
[[nodiscard]] Miss missOfOn(ConditionState const& state, World const& world, CircuitSight& circuits);

/// Of the subjects, one of which must be off, and none is: the connections that hold the circuit of the
/// nearest one closed, see waysOfCurrent().
[[nodiscard]] Miss missOfOff(ConditionState const& state, World const& world);

} // namespace trembler::insight
