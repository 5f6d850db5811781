// The files of the program and of mods that commands read, as inputs that no output may replace.
#pragma once

#include "lua/mods/mod.hpp"

#include <vector>

namespace trembler {

class Outputs;
struct GameData;

/// Registers every part and every level of the program, and every file of the loaded mods, as an input.
void readsAll(Outputs& outputs, GameData const& gameData);
/// Registers the description, the scripts, the parts, the levels and the tests of mods as inputs.
void readsAll(Outputs& outputs, std::vector<lua::Mod> const& mods);

} // namespace trembler
