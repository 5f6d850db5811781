// Writes a level as a file: the inverse of read_level.hpp.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

/// The level as JSON of the present version. Reading it back gives the same level, bit for bit; members with
/// initial values are left out.
[[nodiscard]] nlohmann::ordered_json writeLevel(LevelFile const& level);
/// The text of the level's file: indented, with a newline at the end.
[[nodiscard]] std::string levelText(LevelFile const& level);
/// One recorded solution, as an entry of a level's list.
[[nodiscard]] nlohmann::ordered_json writeSolution(Solution const& solution);
/// The count of an entry of a toolbox: a number, or "unlimited".
[[nodiscard]] nlohmann::ordered_json countJson(int count);

} // namespace trembler
