// The files of the program and of mods that commands read, as inputs that no output may replace.
#pragma once

#include "lua/mods/mod.hpp"

#include <filesystem>
#include <vector>

namespace trembler {

class GameDataByMods;
class Outputs;
struct GameData;

/// Registers every level, part, text and other file that comes with the program, and every file of the loaded
/// mods, as an input.
void readsAll(Outputs& outputs, GameData const& gameData);
/// Registers the level, and the files of the mods that it names; of a mod that cannot be read, every file in
/// its folder, so that an output does not replace what has a mistake in it.
void readsLevel(Outputs& outputs, GameDataByMods& data, std::filesystem::path const& level);
/// Registers the description, the scripts, the parts, the levels and the tests of mods as inputs.
void readsAll(Outputs& outputs, std::vector<lua::Mod> const& mods);

} // namespace trembler
