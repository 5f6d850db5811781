// The way that a condition of the kind "moved" demands.
#pragma once

#include "puzzle/goals/model/condition.hpp"
#include "runtime/math/vec2.hpp"

namespace trembler::conditions {

struct WantedMove {
    double distance = 0; ///< m, from the object's place at the start
    Vec2 towards;        ///< unit; zero: in any direction
};

/// Throws std::bad_any_cast for a condition of another kind.
[[nodiscard]] WantedMove wantedMove(Condition const& condition);

/// A whole condition of this kind, with its key: the first inner condition that an editor puts into a new
/// condition on conditions.
[[nodiscard]] nlohmann::ordered_json movedDraft(ConditionDraft const& with);

} // namespace trembler::conditions
