// The levels that a command's paths name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace trembler {

struct GameData;

/// Files as they are, and all levels in folders, those of mods included, in order of their paths; each once.
/// Without any path all levels of the program, and those of the mods that come with it. Throws
/// std::invalid_argument if a folder has none, InputError if a file cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> levelsNamed(GameData const& gameData,
                                                             std::vector<std::string> const& paths);

} // namespace trembler
