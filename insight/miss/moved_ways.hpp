// How far the subjects of a condition "moved" have come.
#pragma once

#include "insight/miss/condition_miss.hpp"

#include <vector>

namespace trembler::insight {

struct MovedWay {
    ObjectId object;
    Vec2 at;         ///< m, in the world: where it is now
    Vec2 way;        ///< m, from where it was at the start
    double done = 0; ///< m, of that in the wanted direction; its length if any direction will do
};

/// A way for each subject that still exists. `one` must be of the kind "moved".
[[nodiscard]] std::vector<MovedWay> movedWays(ConditionMiss const& one, World const& world);

} // namespace trembler::insight
