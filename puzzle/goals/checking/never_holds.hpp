// Goals that nothing in their level can ever reach.
#pragma once

#include "puzzle/goals/model/condition.hpp"
#include "runtime/world/world.hpp"

namespace trembler {

/// Complains about each condition, the inner ones included, that cannot hold whatever happens: an object that
/// touches itself only, something fixed that moves or gets elsewhere, more objects than there can be. What
/// the player may place counts; what only arises while the world runs does not, as goals do not speak of it.
/// The world is the level's, before its first frame.
void complainIfNever(Condition const& condition, LevelFile const& level, World const& world,
                     Problems& problems);

} // namespace trembler
