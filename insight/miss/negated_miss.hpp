// How far a condition that is met is from being met no longer.
#pragma once

#include "insight/miss/condition_miss.hpp"

namespace trembler::insight {

/// For a condition under "not", which should not be met: `inside`: the way out of the area; `moved`: the way
/// back below the distance; `touching`: the pairs that touch; `on`: the connections that hold the circuit
/// closed; `off`: what `on` lacks; `count`: of objects; `all`: the nearest of its children, `any`: their
/// mean. Of measure 0 if it is not met. A sequence that is done stays done, so nothing is nearer to undoing
/// it: of measure 1.
[[nodiscard]] Miss negatedMiss(ConditionMiss const& one, World const& world, CircuitSight& circuits);

} // namespace trembler::insight
