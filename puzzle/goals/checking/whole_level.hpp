// A level as a whole, for checks of its goals that need more than the objects that they name.
#pragma once

#include "puzzle/goals/checking/candidates.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/world.hpp"

namespace trembler {

/// Everything in it must outlive it. The world is that of the level, before its first frame.
struct WholeLevel {
    PartLibrary const& parts;
    LevelFile const& level;
    World const& world;
    CandidateFinder const& candidates;
};

} // namespace trembler
