// Checks that a level is what it claims to be.
#pragma once

#include "puzzle/data/game_data.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace trembler {

/// What is wrong with a level, a line each; empty if it is valid: it loads; with an empty toolbox it is not
/// solved within 60 s (a demonstration: it is); each recorded solution fits and ends as recorded; and every
/// run, repeated on another number of threads, ends in the same state. `detail` overrules the detail levels
/// that the level asks for. Takes seconds.
[[nodiscard]] std::vector<std::string> verifyLevel(GameData const& gameData,
                                                   std::filesystem::path const& level,
                                                   std::map<std::string, std::string> const& detail = {});

} // namespace trembler
