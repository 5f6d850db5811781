#include "puzzle/edit/inspect/solution_forms.hpp"

#include "puzzle/edit/tree/tree_access.hpp"

#include <algorithm>
#include <optional>

namespace trembler::edit {
namespace {

constexpr double farthest = 1e6; ///< of numbers for which the schema has no limits

/// The schema itself, or the definition that it refers to.
Json resolved(Json const& schema, Json const& root) {
    auto const reference = schema.is_object() ? schema.find("$ref") : schema.end();
    if (!schema.is_object() || reference == schema.end()) {
        return schema;
    }
    std::string const name = reference->get<std::string>();
    if (name.ends_with("/name") || name.ends_with("/point")) {
        return schema; // they are fields
    }
    return resolved(root.at(Json::json_pointer(name.substr(1))), root);
}

bool refersTo(Json const& schema, std::string_view name) {
    auto const reference = schema.is_object() ? schema.find("$ref") : schema.end();
    return schema.is_object() && reference != schema.end() &&
           reference->get<std::string>() == std::string("#/$defs/").append(name);
}

bool isRequired(Json const& schema, std::string const& key) {
    auto const required = schema.find("required");
    return required != schema.end() &&
           std::find(required->begin(), required->end(), Json(key)) != required->end();
}

/// A list of two or more values of one kind, of which none can be left out.
bool isTuple(Json const& schema) {
    return schema.contains("items") && schema.contains("minItems") && schema.contains("maxItems") &&
           schema["minItems"] == schema["maxItems"];
}

std::string fieldNameOf(std::string key) {
    if (key.ends_with("_deg")) {
        key.resize(key.size() - 4);
    }
    std::replace(key.begin(), key.end(), '_', ' ');
    if (!key.empty() && key.front() >= 'a' && key.front() <= 'z') {
        key.front() = static_cast<char>(key.front() - 'a' + 'A');
    }
    return key;
}

/// The narrowest statement about numbers: of several possible ones that with limits.
Json const& ofNumbers(Json const& schema) {
    auto const any = schema.find("anyOf");
    if (any != schema.end()) {
        for (Json const& one : *any) {
            if (one.contains("minimum")) {
                return one;
            }
        }
    }
    return schema;
}

class FieldMaker {
public:
    FieldMaker(EntryNames const& names, Json const& entry) : names_(names), entry_(entry) {}

    std::vector<InspectedField> fields;

    void addMembers(Json const& schema, std::string const& around) {
        for (auto const& member : schema["properties"].items()) {
            add(member.value(), around + "/" + member.key(), member.key(), isRequired(schema, member.key()));
        }
    }

    void add(Json const& schema, std::string const& place, std::string const& key, bool required) {
        if (schema.contains("const")) {
            return;
        }
        if (schema.contains("properties")) {
            addMembers(schema, place);
        } else if (isTuple(schema)) {
            for (std::size_t i = 0; i < schema["minItems"].get<std::size_t>(); ++i) {
                add(schema["items"], place + "/" + std::to_string(i), key, true);
            }
        } else {
            addOne(schema, place, key, required);
        }
    }

private:
    void addOne(Json const& schema, std::string const& place, std::string const& key, bool required) {
        InspectedField field;
        field.place = place;
        field.name = fieldNameOf(key);
        field.unit = key.ends_with("_deg") ? "°" : "";
        field.help = schema.value("description", "");
        field.required = required;
        field.minimum = -farthest;
        field.maximum = farthest;
        Json::json_pointer const at(place);
        field.stated = entry_.contains(at);
        field.value = field.stated ? entry_.at(at) : Json();
        std::string const type = schema.value("type", "");
        if (refersTo(schema, "point")) {
            field.type = FieldType::vector;
            field.unit = "m";
        } else if (refersTo(schema, "name") || type == "string") {
            field.type = FieldType::object;
            field.choices = withStated(key == "part" ? names_.parts : names_.objects, field.value);
        } else if (type == "boolean") {
            field.type = FieldType::boolean;
        } else if (schema.contains("enum") && schema["enum"].front().is_string()) {
            field.type = FieldType::choice;
            for (Json const& choice : schema["enum"]) {
                field.choices.push_back(choice.get<std::string>());
            }
            if (!required) {
                field.choices.insert(field.choices.begin(), ""); // not stated
                field.choices.erase(std::unique(field.choices.begin(), field.choices.end()),
                                    field.choices.end());
            }
        } else {
            addLimits(schema, field);
        }
        fields.push_back(std::move(field));
    }

    /// Of a number, or of a few whole numbers that the schema lists.
    static void addLimits(Json const& schema, InspectedField& field) {
        if (schema.contains("enum")) {
            field.type = FieldType::integer;
            field.minimum = schema["enum"].front().get<double>();
            field.maximum = schema["enum"].back().get<double>();
            return;
        }
        Json const& numbers = ofNumbers(schema);
        field.type = numbers.value("type", "") == "integer" ? FieldType::integer : FieldType::number;
        bool const orNone = &numbers != &schema; // 0 is allowed besides
        field.minimum = orNone ? 0 : numbers.value("minimum", -farthest);
        field.maximum = numbers.value("maximum", farthest);
    }

    static std::vector<std::string> withStated(std::vector<std::string> names, Json const& value) {
        if (value.is_string() && std::find(names.begin(), names.end(), value) == names.end()) {
            names.push_back(value.get<std::string>());
        }
        return names;
    }

    EntryNames const& names_;
    Json const& entry_;
};

/// Values that a new entry must have.
class EntryMaker {
public:
    EntryMaker(EntryNames const& names, Vec2 at) : names_(names), at_(at) {}

    Json make(Json const& schema, std::string const& key) {
        if (schema.contains("const")) {
            return schema["const"];
        }
        if (schema.contains("properties")) {
            return object(schema);
        }
        if (isTuple(schema)) {
            Json list = Json::array();
            while (list.size() < schema["minItems"].get<std::size_t>()) {
                list.push_back(make(schema["items"], key));
            }
            return list;
        }
        if (refersTo(schema, "point")) {
            return pointJson(at_);
        }
        if (refersTo(schema, "name") || schema.value("type", "") == "string") {
            return key == "part" ? nameOf(names_.parts, 0) : nameOf(names_.objects, objects_++);
        }
        if (schema.contains("enum")) {
            return schema["enum"].front();
        }
        return ofNumbers(schema).value("minimum", Json(0));
    }

private:
    Json object(Json const& schema) {
        Json made = Json::object();
        bool const oneAtLeast = schema.contains("minProperties");
        for (auto const& member : schema["properties"].items()) {
            if (isRequired(schema, member.key()) || (oneAtLeast && made.empty())) {
                Json value = make(member.value(), member.key());
                if (value.is_object() && value.empty()) { // an object of which nothing must be stated
                    auto const& first = member.value()["properties"].items().begin();
                    value[first.key()] = make(first.value(), first.key());
                }
                made[member.key()] = std::move(value);
            }
        }
        return made;
    }
    static Json nameOf(std::vector<std::string> const& names, std::size_t index) {
        return index < names.size() ? names[index] : std::string();
    }

    EntryNames const& names_;
    Vec2 at_;
    std::size_t objects_ = 0;
};

/// The first required member that no other kind has.
std::string tellingKey(std::vector<Json> const& kinds, std::size_t index) {
    for (auto const& member : kinds[index]["properties"].items()) {
        bool alone = isRequired(kinds[index], member.key());
        for (std::size_t other = 0; other < kinds.size(); ++other) {
            alone = alone && (other == index || !kinds[other]["properties"].contains(member.key()));
        }
        if (alone) {
            return member.key();
        }
    }
    return {};
}

} // namespace

EntryForm const* EntryList::formOf(Json const& entry) const {
    auto const found = std::find_if(forms.begin(), forms.end(), [&](EntryForm const& form) {
        return form.key.empty() || (entry.is_object() && entry.contains(form.key));
    });
    return found == forms.end() ? nullptr : &*found;
}

std::vector<EntryList> solutionLists(Json const& levelSchema) {
    std::vector<EntryList> lists;
    for (auto const& member : levelSchema.at("$defs").at("solution").at("properties").items()) {
        if (!member.value().contains("items")) {
            continue;
        }
        Json const entry = resolved(member.value()["items"], levelSchema);
        std::vector<Json> kinds;
        if (auto const several = entry.find("oneOf"); several != entry.end()) {
            kinds.assign(several->begin(), several->end());
        } else {
            kinds.push_back(entry);
        }
        EntryList list{member.key(), {}};
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            list.forms.push_back({kinds.size() == 1 ? std::string() : tellingKey(kinds, i), kinds[i]});
        }
        lists.push_back(std::move(list));
    }
    return lists;
}

std::vector<InspectedField> fieldsOfEntry(EntryForm const& form, Json const& entry, EntryNames const& names) {
    FieldMaker maker(names, entry);
    maker.add(form.schema, "", form.key, true);
    return std::move(maker.fields);
}

Json entryWith(Json entry, InspectedField const& field, Json const& value) {
    if (field.required || (!value.is_null() && value != Json(""))) {
        entry[Json::json_pointer(field.place)] = value;
        return entry;
    }
    Json::json_pointer place(field.place);
    while (!place.empty() && entry.contains(place)) {
        std::string const key = place.back();
        place.pop_back();
        entry.at(place).erase(key);
        if (!entry.at(place).empty()) {
            break;
        }
    }
    return entry;
}

Json newEntry(EntryForm const& form, EntryNames const& names, Vec2 at) {
    return EntryMaker(names, at).make(form.schema, form.key);
}

} // namespace trembler::edit
