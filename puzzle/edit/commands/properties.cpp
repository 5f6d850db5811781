#include "puzzle/edit/commands/properties.hpp"

#include "puzzle/edit/tree/object_values.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/model/detail_levels.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/level/property/property_reader.hpp"
#include "runtime/level/property/property_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace trembler::edit {
namespace {

using Names = std::vector<std::string>;
using Pointer = Json::json_pointer;

/// The text that a property begins with: its initial values, and required fields that any reader accepts.
Json initialStatement(PropertyInfo const& info) {
    auto const value = info.makeValue();
    auto const fields = outlineOf(*value);
    if (info.text.key == "shape") { // a list of pieces must not be empty
        return Json::array({Json{{"form", "box"}}});
    }
    if (fields.empty()) {
        return true;
    }
    if (isBare(fields) && fields.front().type == FieldType::boolean) {
        return true;
    }
    Json written = writeProperty(*value);
    NameTable names;
    if (readValue(info, written, names)) {
        return written;
    }
    // A required number whose initial value is out of range: the nearest round one within.
    auto const within = [](FieldInfo const& field) {
        double const least = isAngle(field.unit) ? degrees(field.minimum) : field.minimum;
        return numberJson(field.minimumExcluded || least <= 0 ? std::max(1.0, least) : least);
    };
    for (FieldOutline const& field : fields) {
        if (!isNumber(field)) {
            continue;
        }
        if (isBare(fields)) {
            written = within(field.info);
        } else if (field.info.required) {
            if (!written.is_object()) {
                written = Json::object();
            }
            written[std::string(field.info.key)] = within(field.info);
        }
    }
    return written;
}

/// The token of a list's entry; nothing for anything else.
std::optional<std::size_t> indexIn(std::string const& token) {
    bool const digits = !token.empty() && token.size() < 9 &&
                        std::all_of(token.begin(), token.end(), [](char c) { return c >= '0' && c <= '9'; });
    return digits ? std::optional<std::size_t>(std::stoul(token)) : std::nullopt;
}

/// Sets what is at a place of a value, making objects that are missing on the way; null removes a member.
void setAt(Json& value, std::string const& field, Json const& to) {
    if (field.empty()) {
        value = to;
        return;
    }
    Pointer const whole = [&] {
        try {
            return Pointer(field);
        } catch (Json::exception const&) {
            throw CommandError(fmt::format("'{}' is no place in a property", field));
        }
    }();
    Json* node = &value;
    std::vector<std::string> tokens;
    for (Pointer rest = whole; !rest.empty(); rest = rest.parent_pointer()) {
        tokens.insert(tokens.begin(), rest.back());
    }
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        bool const last = i + 1 == tokens.size();
        if (node->is_array()) {
            auto const index = indexIn(tokens[i]);
            if (!index || *index >= node->size()) {
                throw CommandError(fmt::format("there is no entry '{}'", tokens[i]));
            }
            node = &(*node)[*index];
        } else {
            if (!node->is_object()) { // `true` stands for initial values
                *node = Json::object();
            }
            if (last && to.is_null()) {
                node->erase(tokens[i]);
                return;
            }
            node = &(*node)[tokens[i]];
        }
    }
    *node = to;
}

/// Throws CommandError, in the reader's words, for a value that files may not state.
void mustBeReadable(PropertyInfo const& info, Json const& value) {
    NameTable names;
    std::string why;
    if (!readValue(info, value, names, &why)) {
        throw CommandError(fmt::format("{}: {}", info.text.name, why));
    }
}

std::string propertyInWords(PropertyInfo const& info) {
    std::string words(info.text.name);
    if (words.size() > 1 && words[1] >= 'a' && words[1] <= 'z' && words[0] >= 'A' && words[0] <= 'Z') {
        words[0] = static_cast<char>(words[0] - 'A' + 'a');
    }
    return words;
}

/// Changes what each object has of a property. `change` gets null if it does not have it.
template <class Change>
Command changeProperty(GameData const& data, Json const& level, Names const& names,
                       std::string const& property, char const* what, Change change) {
    mustHaveObjects(level, names);
    PropertyInfo const& info = propertyNamed(data, property);
    if (info.text.place == PropertyPlace::world || info.text.key == "name") {
        throw CommandError(fmt::format("'{}' is no property to be set for objects", property));
    }
    return {fmt::format(fmt::runtime(what), propertyInWords(info), objectsInWords(names)),
            [&data, &info, names, change](Json& tree) {
                ObjectEntries const entries(tree);
                for (std::string const& name : names) {
                    Json& entry = entries.of(name);
                    Json const before = effectiveStatement(data, entry, info);
                    Json after = before;
                    change(after);
                    if (after == before && !before.is_null()) {
                        continue;
                    }
                    mustBeReadable(info, after);
                    setStatement(entry, info, std::move(after));
                }
            },
            names};
}

PropertyInfo const& jointInfo(GameData const& data) {
    return propertyNamed(data, "joint");
}

} // namespace

Command setField(GameData const& data, Json const& level, Names const& names, std::string const& property,
                 std::string const& field, Json const& value) {
    PropertyInfo const& info = propertyNamed(data, property);
    return changeProperty(data, level, names, property, "Change {} of {}",
                          [&info, field, value](Json& stated) {
                              if (stated.is_null()) {
                                  stated = initialStatement(info);
                              }
                              setAt(stated, field, value);
                          });
}

Command addProperty(GameData const& data, Json const& level, Names const& names,
                    std::string const& property) {
    PropertyInfo const& info = propertyNamed(data, property);
    return changeProperty(data, level, names, property, "Add {} of {}", [&info](Json& stated) {
        if (stated.is_null()) {
            stated = initialStatement(info);
        }
    });
}

Command resetProperty(GameData const& data, Json const& level, Names const& names,
                      std::string const& property) {
    mustHaveObjects(level, names);
    PropertyInfo const& info = propertyNamed(data, property);
    if (info.text.key == "name") {
        throw CommandError("a name cannot be reset");
    }
    return {fmt::format("Reset {} of {}", propertyInWords(info), objectsInWords(names)),
            [&info, names](Json& tree) {
                for (std::string const& name : names) {
                    setStatement(objectEntry(tree, name), info, {});
                }
            },
            names};
}

Command removeProperty(GameData const& data, Json const& level, Names const& names,
                       std::string const& property) {
    mustHaveObjects(level, names);
    PropertyInfo const& info = propertyNamed(data, property);
    if (info.text.place != PropertyPlace::properties) {
        throw CommandError(fmt::format("'{}' cannot be removed", property));
    }
    return {fmt::format("Remove {} of {}", propertyInWords(info), objectsInWords(names)),
            [&data, &info, names](Json& tree) {
                for (std::string const& name : names) {
                    Json& entry = objectEntry(tree, name);
                    bool const hides = !partStatement(data, entry, info).is_null();
                    setStatement(entry, info, hides ? Json(false) : Json());
                }
            },
            names};
}

Command addListEntry(GameData const& data, Json const& level, Names const& names, std::string const& property,
                     std::string const& list, Json const& entry) {
    return changeProperty(data, level, names, property, "Change {} of {}", [list, entry](Json& stated) {
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
                        std::string const& property, std::string const& list, std::size_t index) {
    return changeProperty(data, level, names, property, "Change {} of {}", [list, index](Json& stated) {
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

Command resetJointField(GameData const& data, Json const& level, std::size_t joint,
                        std::string const& field) {
    Command reset = setJointField(data, level, joint, field, {});
    reset.name = fmt::format("Reset {} of joint", field.empty() ? field : field.substr(1));
    return reset;
}

} // namespace trembler::edit
