// Commands on properties of objects, of the world and of joints.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/level/model/level.hpp"

#include <optional>
#include <string>
#include <vector>

namespace trembler::edit {

// Values are in the form of files: angles in degrees, vectors as [x, y], choices and objects by name. A value
// that the file reader refuses is refused, in the reader's words, by CommandError. `property` is a key such
// as "mass" or "at"; properties of placement are included. `field` is the place inside the property as a JSON
// pointer (RFC 6901): "" for the whole property (and for a bare one, such as a mass), "/colour", "/0/width".

// With `piece`, these are about the piece of that name of each of the objects, which are made from composite
// parts: files state that under "pieces". A piece has no properties of placement. One that an object neither
// has nor states anything about is refused.

/// Sets one field, of one object or of many. An object that has the property only from its part gets a copy
/// of the part's with that field changed; one that does not have it gets it, with initial values elsewhere.
[[nodiscard]] Command setField(GameData const& data, Json const& level, std::vector<std::string> const& names,
                               std::string const& property, std::string const& field, Json const& value,
                               std::string const& piece = {});
/// Adds a property with its initial values, where it is missing. Required fields get the smallest valid
/// value.
[[nodiscard]] Command addProperty(GameData const& data, Json const& level,
                                  std::vector<std::string> const& names, std::string const& property,
                                  std::string const& piece = {});
/// Removes the objects' own statements, so that the part's value applies again.
[[nodiscard]] Command resetProperty(GameData const& data, Json const& level,
                                    std::vector<std::string> const& names, std::string const& property,
                                    std::string const& piece = {});
/// Takes the property away, also if the part states it (then as `false`).
[[nodiscard]] Command removeProperty(GameData const& data, Json const& level,
                                     std::vector<std::string> const& names, std::string const& property,
                                     std::string const& piece = {});
/// Removes all that the objects state about a piece, so that it is as in their part; also about one that the
/// part does not have.
[[nodiscard]] Command resetPiece(Json const& level, std::vector<std::string> const& names,
                                 std::string const& piece);
/// Adds an entry to, or removes one from, a list inside a property: `list` is its place, "" for a bare one.
/// An entry of null is one with initial values.
[[nodiscard]] Command addListEntry(GameData const& data, Json const& level,
                                   std::vector<std::string> const& names, std::string const& property,
                                   std::string const& list, Json const& entry, std::string const& piece = {});
[[nodiscard]] Command removeListEntry(GameData const& data, Json const& level,
                                      std::vector<std::string> const& names, std::string const& property,
                                      std::string const& list, std::size_t index,
                                      std::string const& piece = {});

/// Sets a field of a property of the world, such as "gravity".
[[nodiscard]] Command setWorldField(GameData const& data, Json const& level, std::string const& property,
                                    std::string const& field, Json const& value);
/// Removes a property of the world, so that it is as in a level that does not state it.
[[nodiscard]] Command resetWorldProperty(Json const& level, std::string const& property);
/// "bounds"; nothing removes them.
[[nodiscard]] Command setBounds(Json const& level, std::optional<Box> const& bounds);
/// A detail level of an effect; an empty one lets the scene determine it.
[[nodiscard]] Command setDetail(GameData const& data, Json const& level, std::string const& effect,
                                std::string const& detail);

/// Sets a field of the joint with that index in "joints", or removes it if `value` is null; fields that its
/// form does not have are kept.
[[nodiscard]] Command setJointField(GameData const& data, Json const& level, std::size_t joint,
                                    std::string const& field, Json const& value);

/// Throws CommandError, in the reader's words, for an entry of "joints" that no file may have.
void mustBeJoint(GameData const& data, Json const& joint);

} // namespace trembler::edit
