// Mods on the command line: which a level needs, where they are, and what their scripts say.
#pragma once

#include "puzzle/data/game_data.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace trembler {

/// Adds the option --mod DIR to a command.
void addModFolders(CLI::App& command, std::vector<std::string>& folders);

/// All that the game knows, with the mods that the level names. `folders` are those of --mod. Throws
/// InputError if a mod is not there or wrong.
[[nodiscard]] std::unique_ptr<GameData const> gameDataFor(std::filesystem::path const& level,
                                                          std::vector<std::string> const& folders);

/// Registers the interactions of every mod in the folders. Throws InputError if one is wrong.
void registerModsIn(Registry& registry, std::vector<std::string> const& folders);

/// Writes what scripts have said since the last time to standard error: errors, and what they log.
void tellScriptMessages(GameData const& gameData);

} // namespace trembler
