// Some objects of a level with the joints and connections among them: to be copied, duplicated, or made into
// a part.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/math/vec2.hpp"

#include <string>
#include <vector>

namespace trembler::edit {

/// {"objects", "joints", "connections", "groups"}: the entries of the objects in the order of the file, the
/// joints whose objects are all among them (gears also need their joints), the connections and groups among
/// them. Lists that would be empty are left out. Throws CommandError if an object does not exist.
[[nodiscard]] Json subsetOf(GameData const& data, Json const& level, std::vector<std::string> const& names);
/// Renames the objects and joints of a subset so that none of their names is taken in the level; references
/// follow. Returns the names of the objects.
std::vector<std::string> makeUnique(GameData const& data, Json& subset, Json const& level);
/// Moves everything in a subset, m.
void shiftSubset(Json& subset, Vec2 by);
/// Adds a subset to a level.
void addSubset(Json& level, Json const& subset);
/// Moves the points of a joint: `a` is added to those at its first object, `b` to those at its second, and to
/// the fixed points of pulleys if both are equal.
void shiftJoint(Json& joint, Vec2 a, Vec2 b);
/// Removes objects with all that refers to them: see removeObjects().
void removeEntries(GameData const& data, Json& level, std::vector<std::string> const& names);

} // namespace trembler::edit
