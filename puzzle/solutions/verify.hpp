// Checks that a level is valid and that its solutions solve it.
#pragma once

#include "puzzle/data/game_data.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace trembler {

/// The faults of a level, a line each; empty if it is valid. A valid level loads, and
/// checkWholeLevel() finds nothing wrong with it; with an empty toolbox it is
/// not solved within 60 s (a demonstration is solved); each recorded solution fits and ends as recorded; and
/// every run, repeated on another number of threads, ends in the same state. `detail` overrides the detail
/// levels that the level states. Takes seconds.
[[nodiscard]] std::vector<std::string> verifyLevel(GameData const& gameData,
                                                   std::filesystem::path const& level,
                                                   std::map<std::string, std::string> const& detail = {});

} // namespace trembler
