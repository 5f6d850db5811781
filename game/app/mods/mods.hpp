// Mods on the command line: which a level needs, where they are, and the messages of their scripts.
#pragma once

#include "puzzle/data/game_data.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace trembler {

/// Adds the options --mod DIR and --trust MOD to a command.
void addModFolders(CLI::App& command, std::vector<std::string>& folders);
/// Adds --mod DIR only. A folder without a mod is refused.
void addModFolderOption(CLI::App& command, std::vector<std::string>& folders, std::string const& meaning);

/// All that the game knows, with the mods that the level names. `folders` are those of --mod. Throws
/// InputError if a mod is not there or wrong.
[[nodiscard]] std::unique_ptr<GameData const> gameDataFor(std::filesystem::path const& level,
                                                          std::vector<std::string> const& folders);

/// The same with the mods of these names and those that they need, of the installed ones.
[[nodiscard]] std::unique_ptr<GameData const> gameDataWith(std::vector<std::string> const& mods,
                                                           std::vector<std::string> const& folders);

/// The game data of many levels, one for all that need the same mods from the same folders.
class GameDataByMods {
public:
    explicit GameDataByMods(std::vector<std::string> folders) : folders_(std::move(folders)) {}
    /// Like gameDataFor(). Valid as long as this lives.
    [[nodiscard]] GameData const& dataFor(std::filesystem::path const& level);

    /// The folders in which the mods of the level would be, whether they are right or not. Empty if the level
    /// cannot be read.
    [[nodiscard]] std::vector<std::filesystem::path> modFoldersFor(std::filesystem::path const& level) const;

private:
    std::vector<std::string> folders_;
    std::map<std::vector<std::filesystem::path>, std::unique_ptr<GameData const>> byMods_;
};

/// Every mod in the folders; a folder may also be that of one mod. Throws InputError if one is wrong.
[[nodiscard]] std::vector<lua::Mod> modsIn(std::vector<std::string> const& folders);
/// Registers their interactions. Throws InputError if one is wrong.
void registerModsIn(Registry& registry, std::vector<lua::Mod> const& mods);

/// verifyLevel(), to which the scripts that failed and were switched off are failures, too: with the file of
/// the script and the line.
[[nodiscard]] std::vector<std::string>
verifyWithScripts(GameData const& gameData, std::filesystem::path const& level,
                  std::map<std::string, std::string> const& detail = {});

/// Writes the scripts' messages since the last time to standard error: errors, and lines that they log.
void reportScriptMessages(GameData const& gameData);

} // namespace trembler
