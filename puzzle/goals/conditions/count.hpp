// The number of objects that a condition of the kind "count" demands.
#pragma once

#include "puzzle/goals/model/condition.hpp"

namespace trembler::conditions {

/// Of how many objects the child must hold, ends included.
struct WantedCount {
    int least = 0;
    int most = 0; ///< the greatest int: no limit
};

/// Throws std::bad_any_cast for a condition of another kind.
[[nodiscard]] WantedCount wantedCount(Condition const& condition);

} // namespace trembler::conditions
