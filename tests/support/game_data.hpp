// The game's properties, components and parts, read once for all tests of a program.
#pragma once

#include "puzzle/data/game_data.hpp"

namespace trembler {

/// Without mods. Lives as long as the program.
[[nodiscard]] inline GameData const& gameData() {
    static GameData const shared;
    return shared;
}

} // namespace trembler
