// The author's own parts: made from objects of a level.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace trembler::edit {

struct PartNames {
    std::string name;  ///< by which levels refer to it
    std::string title; ///< for players; empty: the name
    std::string text;  ///< its description for players; may be empty
};

/// The part definition made from objects of a level. Of one object, a simple one ("properties"); of several,
/// a composite one: {"name", "title", "text", "main", "objects", "joints", "connections"}, with the joints
/// and connections among them. Places are relative to those of the main object `main`, whose place and angle
/// a level will state. A simple part contains the properties that the object has from its own part, as parts
/// do not refer to parts. Throws CommandError for a name that is no valid one or that a part has already.
[[nodiscard]] Json partFrom(GameData const& data, Json const& level, std::vector<std::string> const& names,
                            std::string const& main, PartNames const& partNames);
/// Writes a part definition, completely or not at all, into the folder of the author's own parts, which is
/// made if it does not exist. The file's name is made from the part's. Never overwrites another file. Returns
/// its path. Throws OutputError.
std::filesystem::path writePart(std::filesystem::path const& folder, Json const& part);
/// Replaces objects by one made from the part, at the place and with the name of the main one; references to
/// it stay valid. For after a part was made from them and the library has it.
[[nodiscard]] Command replaceByPart(GameData const& data, Json const& level,
                                    std::vector<std::string> const& names, std::string const& main,
                                    std::string const& part);

} // namespace trembler::edit
