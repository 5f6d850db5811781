#include "puzzle/edit/commands/properties.hpp"

#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/tree/object_values.hpp"
#include "puzzle/edit/tree/part_statements.hpp"
#include "puzzle/edit/tree/stated_value.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/model/detail_levels.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::edit {
namespace {

using Names = std::vector<std::string>;
using Pointer = Json::json_pointer;

/// Whose property it is, in words: of objects, or of a piece of each of them.
std::string ownersInWords(Names const& names, std::string const& piece) {
    return piece.empty() ? objectsInWords(names)
                         : fmt::format("piece '{}' of {}", piece, objectsInWords(names));
}

void mustBeForObjects(PropertyInfo const& info, std::string const& piece) {
    bool const ofPiece = piece.empty() || info.text.place == PropertyPlace::properties;
    if (info.text.place == PropertyPlace::world || info.text.key == "name" || !ofPiece) {
        throw CommandError(fmt::format("'{}' is no property to be set for objects", info.text.key));
    }
}

bool statesPiece(Json const& entry, std::string const& piece) {
    auto const pieces = entry.is_object() ? entry.find("pieces") : entry.end();
    return pieces != entry.end() && pieces->is_object() && pieces->contains(piece);
}

void mustHavePiece(GameData const& data, Json const& level, Names const& names, std::string const& piece) {
    PartStatements parts(data);
    for (std::string const& name : piece.empty() ? Names() : names) {
        Json const& entry = *findObject(level, name);
        if (parts.pieceNamed(textOf(entry, "part"), piece).empty() && !statesPiece(entry, piece)) {
            throw CommandError(fmt::format("'{}' has no piece '{}'", name, piece));
        }
    }
}

/// Changes the value that each object, or a piece of each, has of a property. `change` gets null if it does
/// not have it.
template <class Change>
Command changeProperty(GameData const& data, Json const& level, Names const& names,
                       std::string const& property, std::string const& piece, char const* what,
                       Change change) {
    mustHaveObjects(level, names);
    PropertyInfo const& info = propertyNamed(data, property);
    mustBeForObjects(info, piece);
    mustHavePiece(data, level, names, piece);
    return {fmt::format(fmt::runtime(what), propertyInWords(info), ownersInWords(names, piece)),
            [&data, &info, names, piece, change](Json& tree) {
                ObjectEntries const entries(tree);
                PartStatements parts(data);
                for (std::string const& name : names) {
                    Json& entry = entries.of(name);
                    Json const before = effectiveStatement(parts, entry, info, piece);
                    Json after = before;
                    change(after);
                    if (after == before && !before.is_null()) {
                        continue;
                    }
                    mustBeReadable(info, after);
                    setStatement(entry, info, std::move(after), piece);
                }
            },
            names};
}

PropertyInfo const& jointInfo(GameData const& data) {
    return propertyNamed(data, "joint");
}

} // namespace

Command setField(GameData const& data, Json const& level, Names const& names, std::string const& property,
                 std::string const& field, Json const& value, std::string const& piece) {
    PropertyInfo const& info = propertyNamed(data, property);
    return changeProperty(data, level, names, property, piece, "Change {} of {}",
                          [&info, field, value](Json& stated) {
                              if (stated.is_null()) {
                                  stated = initialStatement(info);
                              }
                              setAt(stated, field, value);
                          });
}

Command addProperty(GameData const& data, Json const& level, Names const& names, std::string const& property,
                    std::string const& piece) {
    PropertyInfo const& info = propertyNamed(data, property);
    // An object that must be named: another one, if there is any.
    std::vector<std::string> const all = namesOfObjectsAndPieces(data, level);
    auto const other = std::find_if(all.begin(), all.end(), [&](std::string const& name) {
        return std::find(names.begin(), names.end(), name) == names.end();
    });
    std::string const named = other == all.end() ? names.front() : *other;
    return changeProperty(data, level, names, property, piece, "Add {} of {}", [&info, named](Json& stated) {
        if (stated.is_null()) {
            stated = withRequiredObjects(info, initialStatement(info), named);
        }
    });
}

Command resetProperty(GameData const& data, Json const& level, Names const& names,
                      std::string const& property, std::string const& piece) {
    mustHaveObjects(level, names);
    PropertyInfo const& info = propertyNamed(data, property);
    if (info.text.key == "name") {
        throw CommandError("a name cannot be reset");
    }
    mustBeForObjects(info, piece);
    return {fmt::format("Reset {} of {}", propertyInWords(info), ownersInWords(names, piece)),
            [&info, names, piece](Json& tree) {
                for (std::string const& name : names) {
                    setStatement(objectEntry(tree, name), info, {}, piece);
                }
            },
            names};
}

Command removeProperty(GameData const& data, Json const& level, Names const& names,
                       std::string const& property, std::string const& piece) {
    mustHaveObjects(level, names);
    PropertyInfo const& info = propertyNamed(data, property);
    if (info.text.place != PropertyPlace::properties) {
        throw CommandError(fmt::format("'{}' cannot be removed", property));
    }
    mustHavePiece(data, level, names, piece);
    return {fmt::format("Remove {} of {}", propertyInWords(info), ownersInWords(names, piece)),
            [&data, &info, names, piece](Json& tree) {
                PartStatements parts(data);
                for (std::string const& name : names) {
                    Json& entry = objectEntry(tree, name);
                    setStatement(entry, info, {}, piece);
                    bool const hides = !effectiveStatement(parts, entry, info, piece).is_null();
                    if (hides) {
                        setStatement(entry, info, false, piece);
                    }
                }
            },
            names};
}

Command resetPiece(Json const& level, Names const& names, std::string const& piece) {
    mustHaveObjects(level, names);
    return {fmt::format("Reset piece '{}' of {}", piece, objectsInWords(names)),
            [names, piece](Json& tree) {
                for (std::string const& name : names) {
                    Json& entry = objectEntry(tree, name);
                    if (statesPiece(entry, piece)) {
                        entry["pieces"].erase(piece);
                        dropIfEmpty(entry, "pieces");
                    }
                }
            },
            names};
}

Command addListEntry(GameData const& data, Json const& level, Names const& names, std::string const& property,
                     std::string const& list, Json const& entry, std::string const& piece) {
    PropertyInfo const& info = propertyNamed(data, property);
    return changeProperty(
        data, level, names, property, piece, "Change {} of {}", [&info, list, entry](Json& stated) {
            if (entry.is_null()) {
                stated = withOneMore(info, stated, list);
                return;
            }
            Json now =
                list.empty()
                    ? stated
                    : (stated.is_object() && stated.contains(Pointer(list)) ? stated[Pointer(list)] : Json());
            if (!now.is_array()) {
                now = Json::array();
            }
            now.push_back(entry);
            setAt(stated, list, now);
        });
}

Command removeListEntry(GameData const& data, Json const& level, Names const& names,
                        std::string const& property, std::string const& list, std::size_t index,
                        std::string const& piece) {
    return changeProperty(
        data, level, names, property, piece, "Change {} of {}", [list, index](Json& stated) {
            Pointer const place(list);
            if (!stated.contains(place) || !stated[place].is_array() || index >= stated[place].size()) {
                throw CommandError("there is no such entry");
            }
            stated[place].erase(index);
        });
}

Command setWorldField(GameData const& data, Json const& level, std::string const& property,
                      std::string const& field, Json const& value) {
    PropertyInfo const& info = propertyNamed(data, property);
    if (info.text.place != PropertyPlace::world) {
        throw CommandError(fmt::format("'{}' is no property of the world", property));
    }
    auto const world = level.find("world");
    bool const stated = world != level.end() && world->is_object() && world->contains(property);
    Json made = stated ? (*world)[property] : initialStatement(info);
    setAt(made, field, value);
    mustBeReadable(info, made);
    return {fmt::format("Change {} of the world", propertyInWords(info)),
            [property, made](Json& tree) { objectIn(tree, "world")[property] = made; }};
}

Command resetWorldProperty(Json const& /*level*/, std::string const& property) {
    return {fmt::format("Reset {} of the world", property), [property](Json& tree) {
                if (tree.contains("world")) {
                    objectIn(tree, "world").erase(property);
                    dropIfEmpty(tree, "world");
                }
            }};
}

Command setBounds(Json const& level, std::optional<Box> const& bounds) {
    if (!bounds) {
        Command none = resetWorldProperty(level, "bounds");
        none.name = "Remove bounds";
        return none;
    }
    Json const made = Json::array({numberJson(bounds->corner.x), numberJson(bounds->corner.y),
                                   numberJson(bounds->size.x), numberJson(bounds->size.y)});
    if (bounds->size.x <= 0 || bounds->size.y <= 0) {
        throw CommandError("bounds must have a width and a height above zero");
    }
    return {"Change bounds", [made](Json& tree) { objectIn(tree, "world")["bounds"] = made; }};
}

Command setDetail(GameData const& data, Json const& /*level*/, std::string const& effect,
                  std::string const& detail) {
    auto const all = detailLevels(data.registry);
    auto const known = all.find(effect);
    bool const good = known != all.end() &&
                      (detail.empty() ||
                       std::find(known->second.begin(), known->second.end(), detail) != known->second.end());
    if (!good) {
        throw CommandError(fmt::format("{} has no detail level '{}'", effect, detail));
    }
    return {fmt::format("Change detail of {}", effect), [effect, detail](Json& tree) {
                Json& world = objectIn(tree, "world");
                if (!detail.empty()) {
                    world["detail"][effect] = detail;
                } else if (world.contains("detail") && world["detail"].is_object()) {
                    world["detail"].erase(effect);
                    dropIfEmpty(world, "detail");
                }
                dropIfEmpty(tree, "world");
            }};
}

void mustBeJoint(GameData const& data, Json const& joint) {
    Json fields = joint;
    fields.erase("name");
    mustBeReadable(jointInfo(data), fields);
}

Command setJointField(GameData const& data, Json const& level, std::size_t joint, std::string const& field,
                      Json const& value) {
    mustHaveEntry(level, "joints", joint, "joint");
    Json made = level["joints"][joint];
    setAt(made, field, value);
    if (field == "/form") { // fields that the new form does not have would make it unreadable
        Json const form = made["form"];
        for (auto const& [from, to] : {std::pair{"lower_deg", "lower"}, std::pair{"upper_deg", "upper"},
                                       std::pair{"motor_speed_deg", "motor_speed"}}) {
            bool const angular =
                form == "hinge" || (form == "wheel" && std::string_view(from) == "motor_speed_deg");
            made.erase(angular ? to : from);
        }
    }
    mustBeJoint(data, made);
    return {fmt::format("Change {} of joint", field.empty() ? field : field.substr(1)),
            [joint, made](Json& tree) { entryIn(tree, "joints", joint) = made; }};
}

} // namespace trembler::edit
