// The level of free play: a workshop, and every part and wires without a limit.
#pragma once

#include "runtime/level/model/part_library.hpp"

#include <string>
#include <vector>

namespace trembler {

/// The text of the level's file, with a toolbox of all parts of the library. It has no goals. `title` and
/// `text` are for the player, and `texts` are the same in further languages. `mods` are those of which the
/// library has parts: the level names them, so that it can be opened like any other.
[[nodiscard]] std::string freePlayLevel(PartLibrary const& parts, std::string const& title,
                                        std::string const& text, Translations const& texts = {},
                                        std::vector<std::string> const& mods = {});

} // namespace trembler
