#include "tests/game/ui/edit/whole/schema_places.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace schema_places {
namespace {

using edit::Json;

/// Every place of a file that the schema has, with "[]" for an entry of a list and "*" for any key.
class SchemaPlaces {
public:
    explicit SchemaPlaces(Json const& schema) : root_(schema) { add(schema, ""); }

    [[nodiscard]] Places const& all() const { return places_; }

private:
    /// Those below a part of the schema, which describes the value at `path`.
    void add(Json const& schema, std::string const& path) {
        if (auto const reference = schema.find("$ref"); reference != schema.end()) {
            std::string const name = reference->get<std::string>().substr(8); // behind "#/$defs/"
            if (name == "condition") {
                return addConditions(path);
            }
            if (name == "properties" || name == "joint") {
                return; // described once for files and forms
            }
            if (name != "name" && name != "point" && name != "box" && name != "area") {
                return add(root_["$defs"][name], path);
            }
        }
        bool deeper = false;
        for (char const* const several : {"anyOf", "oneOf"}) {
            for (Json const& one : schema.value(several, Json::array())) {
                add(one, path);
                deeper = true;
            }
        }
        Json const members = schema.value("properties", Json::object());
        for (auto const& member : members.items()) {
            add(member.value(), path + "/" + member.key());
            deeper = true;
        }
        Json const patterns = schema.value("patternProperties", Json::object());
        for (auto const& member : patterns.items()) {
            add(member.value(), path + "/*");
            deeper = true;
        }
        if (schema.contains("additionalProperties") && schema["additionalProperties"].is_object()) {
            add(schema["additionalProperties"], path + "/*");
            deeper = true;
        }
        if (schema.contains("items") && !schema.contains("minItems")) { // a list, not a pair of names
            add(schema["items"], path + "/[]");
            deeper = true;
        }
        if (!deeper) {
            places_.insert(path);
        }
    }

    /// The kinds of conditions, and what any of them may state; not the conditions within conditions.
    void addConditions(std::string const& path) {
        for (Json const& one : root_["$defs"]["condition"]["oneOf"]) {
            for (auto const& member : one["properties"].items()) {
                places_.insert(path + "/" + member.key());
            }
        }
    }

    Json const& root_;
    Places places_;
};

/// The places of a value, and of all within it, in the same form.
void placesIn(Json const& value, std::string const& path, Places& places) {
    places.insert(path);
    if (value.is_object()) {
        for (auto const& member : value.items()) {
            placesIn(member.value(), path + "/" + member.key(), places);
        }
    } else if (value.is_array()) {
        for (Json const& entry : value) {
            placesIn(entry, path + "/[]", places);
        }
    }
}

void addDifferences(Json const& before, Json const& now, std::string const& path, Places& places) {
    if (before == now) {
        return;
    }
    if (before.is_object() && now.is_object()) {
        for (auto const& member : now.items()) {
            addDifferences(before.value(member.key(), Json()), member.value(), path + "/" + member.key(),
                           places);
        }
        for (auto const& member : before.items()) {
            if (!now.contains(member.key())) {
                placesIn(member.value(), path + "/" + member.key(), places);
            }
        }
        places.insert(path);
        return;
    }
    if (before.is_array() && now.is_array()) {
        for (std::size_t i = 0; i < std::max(before.size(), now.size()); ++i) {
            addDifferences(i < before.size() ? before[i] : Json(), i < now.size() ? now[i] : Json(),
                           path + "/[]", places);
        }
        places.insert(path);
        return;
    }
    placesIn(now.is_null() ? before : now, path, places);
}

} // namespace
} // namespace schema_places

Places placesOf(edit::Json const& schema) {
    return schema_places::SchemaPlaces(schema).all();
}

Places differences(edit::Json const& before, edit::Json const& now) {
    Places places;
    schema_places::addDifferences(before, now, "", places);
    return places;
}

} // namespace trembler::ui::test
