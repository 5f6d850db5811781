// The values of properties that entries of a level and their parts state.
#pragma once

#include "physics/dynamics/properties/shape.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "puzzle/edit/tree/part_statements.hpp"
#include "runtime/level/property/name_table.hpp"

#include <memory>
#include <optional>
#include <string>

namespace trembler::edit {

/// The value that the reader of files makes of a text; nothing if it refuses it, then with its first message
/// in `why`, if that is given.
[[nodiscard]] std::unique_ptr<PropertyValue> readValue(PropertyInfo const& info, Json const& json,
                                                       NameTable& names, std::string* why = nullptr);
/// The statement of an object about a property, in its entry or under "properties"; nullptr if nothing. With
/// a piece, its statement under "pieces" about that piece of a composite part.
[[nodiscard]] Json const* ownStatement(Json const& entry, PropertyInfo const& info,
                                       std::string const& piece = {});
/// The value of the property that the object's part has, as a file would state it; null if it has no part, or
/// that does not have it.
[[nodiscard]] Json partStatement(GameData const& data, Json const& entry, PropertyInfo const& info);
/// The value that holds for the object: its own statement, else its part's; null if it does not have the
/// property.
[[nodiscard]] Json effectiveStatement(GameData const& data, Json const& entry, PropertyInfo const& info);
/// The same for objects made from any part: of a composite, the statement that applies to that piece or, if
/// it is "", to the main one.
[[nodiscard]] Json effectiveStatement(PartStatements& parts, Json const& entry, PropertyInfo const& info,
                                      std::string const& piece);
/// Whether `false` means that the object does not have the property: not for one that is a bare true or
/// false.
[[nodiscard]] bool falseRemoves(PropertyInfo const& info);
/// The shape that an object will have; nothing if it has none, or none that can be read.
[[nodiscard]] std::optional<Shape> shapeOf(GameData const& data, Json const& entry);

/// Sets the statement of an object, or of its entry about a piece of it, at the place where files state that
/// property; null removes the statement.
void setStatement(Json& entry, PropertyInfo const& info, Json value, std::string const& piece = {});
/// The description of an object property. Throws CommandError if there is none of that key.
[[nodiscard]] PropertyInfo const& propertyNamed(GameData const& data, std::string const& key);

} // namespace trembler::edit
