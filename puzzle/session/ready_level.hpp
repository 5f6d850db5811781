// A level whose world is built, for a session that begins with it.
#pragma once

#include "runtime/level/build/build_world.hpp"
#include "runtime/level/model/level.hpp"

namespace trembler {

/// `built` is what buildLevel() makes from the level with these options and without placements and wires.
/// Texts and goals of the level may be changed after that: no world depends on them.
struct ReadyLevel {
    LevelFile level;
    WorldOptions options;
    BuiltLevel built;
};

} // namespace trembler
