// How much room objects take in a level.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/level/model/level.hpp"

#include <optional>
#include <string>
#include <vector>

namespace trembler::edit {

/// The smallest upright box around the shapes of objects, m. An object without a shape counts as the point
/// where it is. Nothing for an empty list or unknown names.
[[nodiscard]] std::optional<Box> extentOfObjects(GameData const& data, Json const& level,
                                                 std::vector<std::string> const& names);

} // namespace trembler::edit
