// The names of joints for which the file states none.
#pragma once

#include "runtime/level/model/level.hpp"

namespace trembler {

/// The names of a level's joints, in the order in which the level has them. Those without one become "joint
/// 1", "joint 2" ..., numbered by what they state, so that their order in the file does not matter.
[[nodiscard]] std::vector<std::string> jointNames(LevelFile const& level);

} // namespace trembler
