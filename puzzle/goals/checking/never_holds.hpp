// Finds goals that can never be reached in their level.
#pragma once

#include "puzzle/goals/model/condition.hpp"
#include "runtime/world/world.hpp"

namespace trembler {

/// Complains about each condition, the inner ones included, that can never hold: an object that is to touch
/// itself, a fixed object that is to move or to be elsewhere, a count of more objects than there can be.
/// Parts that the player may place count. Objects that come into being while the world runs do not, as no
/// goal refers to them. The world is that of the level, before its first frame.
void complainIfNever(Condition const& condition, LevelFile const& level, World const& world,
                     Problems& problems);

} // namespace trembler
