// The joints by which a part hangs on the world: they go along when the part is put elsewhere.
#pragma once

#include "runtime/math/vec2.hpp"
#include "runtime/world/store.hpp"

#include <span>

namespace trembler::insight {

/// Where a part is put: turned about a point and shifted.
struct PartMotion {
    Vec2 from;       ///< m, a point of the part, in the world
    Vec2 to;         ///< m, where that point is put
    double turn = 0; ///< rad, about it

    [[nodiscard]] Vec2 point(Vec2 at) const {
        Vec2 const arm = at - from;
        return to + (turn == 0 ? arm : rotated(arm, turn));
    }
    [[nodiscard]] Vec2 direction(Vec2 way) const { return turn == 0 ? way : rotated(way, turn); }
};

/// Moves the anchors that the joints of a part have outside of it, after its objects `moved` (ascending) have
/// been moved: as if the part had been placed there from the start. Between frames. These are
///
/// - of the part's own joints, which are among `moved`, all points in the world, such as an axle or the
///   wheels of a pulley;
/// - of a joint that the level states, the pivot or the guide by which it holds the part to the world or to a
///   fixed object. The far end of a rope, a rod or a spring stays where it is: the part hangs on it somewhere
///   else.
///
/// Joints with objects that can move and stay behind are as before, and pull.
void moveJoints(Store& store, std::span<ObjectId const> moved, PartMotion const& motion);

} // namespace trembler::insight
