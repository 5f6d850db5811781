// Commands that add, remove, duplicate and rename objects.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/math/vec2.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler::edit {

/// An object to be added.
struct NewObject {
    std::string part;        ///< empty: none
    Vec2 at;                 ///< m
    double angleDegrees = 0; ///< anticlockwise
    Json properties{};       ///< an object, or null: none
    std::string name{};      ///< wanted name; empty: made from the part. A number is added if it is taken
};

/// The names of the objects of a level, in the order of the file.
[[nodiscard]] std::vector<std::string> objectNames(Json const& level);
/// The entry of an object; nullptr if there is none of that name.
[[nodiscard]] Json const* findObject(Json const& level, std::string const& name);
/// A name like `wanted` that no object, joint or reserved word of the level has: "plank", "plank 2" ...
[[nodiscard]] std::string freeName(Json const& level, std::string const& wanted);

/// Adds an object at the end of "objects".
[[nodiscard]] Command addObject(Json const& level, NewObject const& object);
/// Removes objects, with the joints and connections that refer to them or to pieces of them, and with the
/// editor's own data about them. Goals and recorded solutions that refer to them stay as they are, and become
/// problems: only the author knows what they should say now. Locked objects stay; throws CommandError if all
/// are locked, or one does not exist.
[[nodiscard]] Command removeObjects(GameData const& data, Json const& level,
                                    std::vector<std::string> const& names);
/// Adds copies, `offset` away (m), with the joints and connections among the objects. The copies of a group
/// are a group.
[[nodiscard]] Command duplicateObjects(GameData const& data, Json const& level,
                                       std::vector<std::string> const& names, Vec2 offset);
/// Renames an object, and every reference to it or to a piece of it: in joints, connections, properties,
/// goals, the inputs of recorded solutions, and groups. Throws CommandError if the name is no valid one, or
/// is taken.
[[nodiscard]] Command renameObject(GameData const& data, Json const& level, std::string const& name,
                                   std::string const& to);
/// The same for the joint with that index in "joints", which may have had no name.
[[nodiscard]] Command renameJoint(GameData const& data, Json const& level, std::size_t joint,
                                  std::string const& to);
/// Makes objects from another part, or from none (empty). Their own statements stay.
[[nodiscard]] Command setPart(Json const& level, std::vector<std::string> const& names,
                              std::string const& part);
/// Whether objects are mirrored about their own vertical axes, before they are turned.
[[nodiscard]] Command setFlipped(Json const& level, std::vector<std::string> const& names, bool flipped);

} // namespace trembler::edit
