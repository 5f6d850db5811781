// Finds goals that can never be reached in their level.
#pragma once

#include "puzzle/goals/model/condition.hpp"
#include "runtime/world/world.hpp"

namespace trembler {

/// Complains about each condition, the inner ones included, that can never hold: an object must touch itself,
/// a fixed object must move or be elsewhere, or a count demands more objects than there can be. Parts that
/// the player may place are included. Objects created while the world runs are not, as no goal refers to
/// them. The world is that of the level, before its first frame.
void complainIfNever(Condition const& condition, LevelFile const& level, World const& world,
                     Problems& problems);

} // namespace trembler
