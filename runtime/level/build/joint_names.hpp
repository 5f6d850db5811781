// The names of joints for which the file states none.
#pragma once

#include "runtime/level/model/level.hpp"

#include <span>
#include <string>
#include <vector>

namespace trembler {

/// The names of a level's joints, in the order of the level. Joints without a name become "joint 1", "joint
/// 2" ..., in the order of their contents, so that their order in the file does not matter.
[[nodiscard]] std::vector<std::string> jointNames(LevelFile const& level);
/// The same for the joints of a composite part, among its pieces.
[[nodiscard]] std::vector<std::string> jointNames(std::span<LevelObject const> objects,
                                                  std::span<LevelJoint const> joints,
                                                  NameTable const& references);

} // namespace trembler
