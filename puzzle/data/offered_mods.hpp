// The installed mods that bring parts, for a toolbox that offers every part there is.
#pragma once

#include "puzzle/data/game_data.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace trembler {

/// A mod that cannot be used.
struct LeftOutMod {
    std::string name;
    Diagnostic fault; ///< the first of its faults
};

struct OfferedMods {
    std::shared_ptr<GameData const> data; ///< with all of them; nullptr: there are none
    std::vector<std::string> names;       ///< in order; with those that they need `data` may have more
    std::vector<LeftOutMod> leftOut;
};

/// The game's data with the mods of these names and those that they need. Throws InputError if one of them is
/// missing or wrong.
using ModData = std::function<std::shared_ptr<GameData const>(std::vector<std::string> const& names)>;

/// `installed` are the folders of mods, in the order of their names. A mod without parts is none of these.
/// One that is wrong, or does not go together with those before it, is left out.
[[nodiscard]] OfferedMods offeredMods(std::span<std::filesystem::path const> installed, ModData const& load);

} // namespace trembler
