// A short key of everything that a level's verification depends on.
#pragma once

#include "game/app/mods/mods.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace trembler {

/// The level's file, every file of the mods that it names, and the detail levels that override its own: a
/// hash of them, and the path. The program and its parts are taken to be the same. A level that cannot be
/// read has a key as well.
[[nodiscard]] std::string verificationKey(GameDataByMods& data, std::filesystem::path const& level,
                                          std::map<std::string, std::string> const& detail);

} // namespace trembler
