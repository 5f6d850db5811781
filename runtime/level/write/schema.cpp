#include "runtime/level/write/schema.hpp"

#include "runtime/input/player_input.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/level/property/property_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace trembler {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view draft = "https://json-schema.org/draft/2020-12/schema";

Json reference(std::string_view definition) {
    return Json{{"$ref", fmt::format("#/$defs/{}", definition)}};
}

Json listOf(Json items, std::size_t most = limits::listInProperty) {
    return Json{{"type", "array"}, {"items", std::move(items)}, {"maxItems", most}};
}

/// "minimum" and "maximum" of a field, in the unit of the file.
void addRange(Json& schema, FieldInfo const& info) {
    constexpr double all = std::numeric_limits<double>::max();
    auto const limit = [&](double value) { return isAngle(info.unit) ? degrees(value) : value; };
    if (info.minimum > -all) {
        schema[info.minimumExcluded ? "exclusiveMinimum" : "minimum"] = limit(info.minimum);
    }
    if (info.maximum < all) {
        schema["maximum"] = limit(info.maximum);
    }
}

std::string describe(FieldInfo const& info) {
    std::string_view const unit = info.unit == "rad"     ? "degrees"
                                  : info.unit == "rad/s" ? "degrees/s"
                                                         : info.unit;
    return unit.empty() ? std::string(info.meaning) : fmt::format("{} ({})", info.meaning, unit);
}

/// Gathers the schema of every field. Where fields depend on a choice it is run once for each of them.
class SchemaVisitor final : public FieldVisitor {
public:
    Json properties = Json::object();
    std::set<std::string> required;
    /// How many values the first choice has, and which of them to pretend.
    std::size_t choices = 0;
    int pretended = -1;

    void boolean(FieldInfo const& info, bool&) override { put(info, {{"type", "boolean"}}); }
    void integer(FieldInfo const& info, std::int32_t&) override {
        Json schema{{"type", "integer"}};
        addRange(schema, limits(info));
        put(info, std::move(schema));
    }
    void number(FieldInfo const& info, double&) override {
        Json schema{{"type", "number"}};
        addRange(schema, limits(info));
        put(info, std::move(schema));
    }
    void vector(FieldInfo const& info, Vec2&) override {
        Json item{{"type", "number"}};
        addRange(item, limits(info));
        put(info, {{"type", "array"}, {"items", std::move(item)}, {"minItems", 2}, {"maxItems", 2}});
    }
    void text(FieldInfo const& info, std::string&) override { put(info, {{"type", "string"}}); }
    void object(FieldInfo const& info, ObjectId&) override { put(info, reference("name")); }
    void choice(FieldInfo const& info, ChoiceField field) override {
        if (choices == 0) {
            choices = field.names.size();
            if (pretended >= 0) {
                field.index = pretended;
            }
        }
        Json names = Json::array();
        for (std::string_view const name : field.names) {
            names.push_back(name);
        }
        put(info, {{"enum", std::move(names)}});
    }
    void list(FieldInfo const& info, ListField& field) override {
        bool const hasFields = field.elementsHaveFields();
        SchemaVisitor const element = ofAllVariants([&](SchemaVisitor& visitor) {
            visitor.listInfo_ = hasFields ? nullptr : &info;
            field.resize(0);
            field.resize(1);
            field.visitElement(0, visitor);
        });
        field.resize(0);
        put(info, listOf(hasFields ? element.objectSchema() : element.properties["value"]));
    }
    /// All fields that there can be, whatever the first choice; required are those that always are. visit(v)
    /// shows an initial value to v.
    template <class Visit>
    [[nodiscard]] static SchemaVisitor ofAllVariants(Visit&& visit) {
        SchemaVisitor all;
        visit(all);
        for (int i = 0; i < static_cast<int>(all.choices); ++i) {
            SchemaVisitor variant;
            variant.pretended = i;
            visit(variant);
            for (auto const& [key, schema] : variant.properties.items()) {
                if (!all.properties.contains(key)) {
                    all.properties[key] = schema;
                }
            }
            std::erase_if(all.required,
                          [&](std::string const& key) { return !variant.required.contains(key); });
        }
        return all;
    }
    [[nodiscard]] Json objectSchema() const {
        Json schema{{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
        if (!required.empty()) {
            schema["required"] = required;
        }
        return schema;
    }

private:
    [[nodiscard]] FieldInfo const& limits(FieldInfo const& info) const {
        return listInfo_ == nullptr ? info : *listInfo_;
    }
    void put(FieldInfo const& info, Json schema) {
        std::string const key(info.key);
        if (listInfo_ == nullptr) {
            schema["description"] = describe(info);
        }
        properties[key] = std::move(schema);
        if (info.required) {
            required.insert(key);
        }
    }

    FieldInfo const* listInfo_ = nullptr;
};

/// All fields that a property can have.
SchemaVisitor fieldsOf(PropertyInfo const& info) {
    return SchemaVisitor::ofAllVariants([&](SchemaVisitor& visitor) { info.makeValue()->visit(visitor); });
}

Json withoutDescription(Json schema) {
    schema.erase("description");
    return schema;
}

Json propertiesSchema(Registry const& registry, PropertyPlace place) {
    Json members = Json::object();
    for (PropertyInfo const* info : registry.objectProperties()) {
        if (info->text.place == place && info->text.key != "name") {
            members[std::string(info->text.key)] = propertySchema(*info);
        }
    }
    return Json{{"type", "object"}, {"properties", std::move(members)}, {"additionalProperties", false}};
}

Json strictObject(Json properties, std::vector<std::string> const& required = {}) {
    Json schema{{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
    if (!required.empty()) {
        schema["required"] = required;
    }
    return schema;
}

/// Detail levels by effect; with `or nothing`, "" too, which leaves it to the scene.
Json detailSchema(Registry const& registry, bool orNothing) {
    std::map<std::string, std::vector<std::string>> levels;
    for (Registration const& registration : registry.components()) {
        ComponentText const& text = registration.info->text;
        auto& of = levels[std::string(text.effect)];
        if (!text.level.empty() && std::find(of.begin(), of.end(), text.level) == of.end()) {
            of.emplace_back(text.level);
        }
    }
    Json detail = Json::object();
    for (auto& [effect, of] : levels) {
        if (!of.empty()) {
            if (orNothing) {
                of.emplace_back("");
            }
            detail[effect] = Json{{"enum", of}};
        }
    }
    return strictObject(std::move(detail));
}

/// Of the components that may miss frames.
Json periodsSchema(Registry const& registry) {
    Json periods = Json::object();
    for (Registration const& registration : registry.components()) {
        if (registration.longestPeriod > registration.period) {
            periods[title(*registration.info)] =
                Json{{"type", "integer"}, {"minimum", 1}, {"maximum", registration.longestPeriod}};
        }
    }
    return strictObject(std::move(periods));
}

/// Of one number of the world, as far as it is a matter of accuracy.
Json settingSchema(FieldOutline const& field) {
    Json schema{{"type", field.type == FieldType::integer ? "integer" : "number"},
                {"minimum", field.info.accuracy.from},
                {"maximum", field.info.accuracy.to}};
    if (field.type == FieldType::integer) {
        schema["minimum"] = static_cast<std::int64_t>(field.info.accuracy.from);
        schema["maximum"] = static_cast<std::int64_t>(field.info.accuracy.to);
    }
    if (field.info.accuracy.orAutomatic) {
        schema = Json{{"anyOf", Json::array({Json{{"const", 0}}, std::move(schema)})}};
    }
    schema["description"] = describe(field.info);
    return schema;
}

Json settingsSchema(Registry const& registry) {
    Json settings = Json::object();
    for (PropertyInfo const* info : registry.objectProperties()) {
        if (info->text.place != PropertyPlace::world) {
            continue;
        }
        Json numbers = Json::object();
        for (FieldOutline const& field : outlineOf(*info->makeValue())) {
            bool const number = field.type == FieldType::integer || field.type == FieldType::number;
            if (number && field.info.accuracy.any()) {
                numbers[std::string(field.info.key)] = settingSchema(field);
            }
        }
        if (!numbers.empty()) {
            settings[std::string(info->text.key)] = strictObject(std::move(numbers));
        }
    }
    return strictObject(std::move(settings));
}

Json changeSchema(Registry const& registry) {
    Json const frame{
        {"type", "integer"}, {"minimum", 1}, {"description", "the first that it counts for, from 1"}};
    std::map<std::string_view, Json> bodies{{"detail", detailSchema(registry, true)},
                                            {"period", periodsSchema(registry)},
                                            {"setting", settingsSchema(registry)}};
    Json kinds = Json::array();
    for (std::string_view const kind : recordedChangeNames) {
        Json body = std::move(bodies.at(kind));
        body["minProperties"] = 1;
        Json members{{"frame", frame}};
        members[std::string(kind)] = std::move(body);
        kinds.push_back(strictObject(std::move(members), {"frame", std::string(kind)}));
    }
    return Json{{"description",
                 "How exactly the level is computed from a frame on, never its physics. A detail "
                 "level must compute what the level states; see docs/budget.md."},
                {"oneOf", std::move(kinds)}};
}

Json worldSchema(Registry const& registry) {
    Json world = propertiesSchema(registry, PropertyPlace::world);
    world["description"] = "The world as a whole.";
    world["properties"]["bounds"] = reference("box");
    world["properties"]["detail"] = detailSchema(registry, false);
    world["properties"]["detail"]["description"] =
        "Detail level by effect; what is not stated is picked by the scene.";
    return world;
}

Json objectSchema(Registry const& registry) {
    Json members{{"name", reference("name")},
                 {"part", {{"type", "string"}, {"description", "the part definition that it is made from"}}}};
    Json const placement = propertiesSchema(registry, PropertyPlace::placement);
    for (auto const& [key, schema] : placement["properties"].items()) {
        members[key] = schema;
    }
    members["properties"] = reference("properties");
    return strictObject(std::move(members), {"name"});
}

Json jointSchema(PropertyInfo const& info) {
    SchemaVisitor const fields = fieldsOf(info);
    Json joint = fields.objectSchema();
    joint["properties"]["name"] = reference("name");
    return joint;
}

Json inputSchema() {
    Json const frame{{"type", "integer"},
                     {"minimum", 1},
                     {"maximum", limits::frames},
                     {"description", "the frame that sees it, from 1; not after the solution's last one"}};
    Json kinds = Json::array();
    std::map<std::string_view, Json> const bodies{
        {"grab", reference("name")},
        {"move", reference("point")},
        {"release", Json{{"const", true}}},
        {"cut", Json{{"type", "array"}, {"items", reference("name")}, {"minItems", 2}, {"maxItems", 2}}},
        {"remove", reference("name")}};
    for (std::string_view const kind : playerInputNames) {
        Json members{{"frame", frame}};
        members[std::string(kind)] = bodies.at(kind);
        std::vector<std::string> required{"frame", std::string(kind)};
        if (kind == "grab") {
            members["at"] = reference("point");
            required.emplace_back("at");
        }
        kinds.push_back(strictObject(std::move(members), required));
    }
    return Json{{"oneOf", std::move(kinds)}};
}

Json commonDefinitions() {
    Json const coordinate{{"type", "number"}, {"minimum", -1e6}, {"maximum", 1e6}};
    Json definitions;
    definitions["name"] = Json{{"type", "string"}, {"minLength", 1}, {"maxLength", 100}};
    definitions["point"] = Json{{"type", "array"}, {"items", coordinate}, {"minItems", 2}, {"maxItems", 2}};
    definitions["box"] = Json{{"description", "[x, y, width, height] in m, (x, y) the lower left corner"},
                              {"type", "array"},
                              {"items", coordinate},
                              {"minItems", 4},
                              {"maxItems", 4}};
    Json polygon = listOf(reference("point"), limits::areaCorners);
    polygon["minItems"] = 3;
    definitions["area"] = Json{{"anyOf", Json::array({reference("box"), std::move(polygon)})}};
    return definitions;
}

Json connectionSchema(Registry const& registry) {
    Json pair{{"type", "array"}, {"items", reference("name")}, {"minItems", 2}, {"maxItems", 2}};
    if (registry.connectors().empty()) {
        return pair;
    }
    Json kinds = Json::array();
    for (std::string const& kind : registry.connectionKinds()) {
        kinds.push_back(kind);
    }
    std::string meanings;
    for (Connector const& connector : registry.connectors()) {
        meanings += fmt::format("{}{}: {}", meanings.empty() ? "" : "; ", connector.kind, connector.meaning);
    }
    Json stated =
        strictObject({{"between", pair}, {"kind", {{"enum", std::move(kinds)}, {"description", meanings}}}},
                     {"between", "kind"});
    return Json{{"anyOf", Json::array({std::move(pair), std::move(stated)})}};
}

} // namespace

Json propertySchema(PropertyInfo const& info) {
    auto const value = info.makeValue();
    auto const outline = outlineOf(*value);
    SchemaVisitor const fields = fieldsOf(info);
    Json schema;
    if (outline.empty()) {
        schema = Json{{"type", "boolean"}};
    } else if (isBare(outline)) {
        schema = withoutDescription(fields.properties["value"]);
        if (outline.front().type != FieldType::boolean) {
            schema = Json{{"anyOf", Json::array({std::move(schema), Json{{"const", false}}})}};
        }
    } else {
        Json shortForm = fields.required.empty() ? Json{{"type", "boolean"}} : Json{{"const", false}};
        schema = Json{{"anyOf", Json::array({fields.objectSchema(), std::move(shortForm)})}};
    }
    std::string text(info.text.meaning);
    if (!outline.empty() && isBare(outline)) {
        text += " " + describe(outline.front().info) + ".";
    }
    schema["description"] = text;
    return schema;
}

Json levelSchema(Registry const& registry, Json const& goals) {
    Json const text{{"type", "string"}};
    Json const count{{"type", "integer"}, {"minimum", 1}, {"maximum", limits::toolboxCount}};
    Json definitions = commonDefinitions();
    definitions["properties"] = propertiesSchema(registry, PropertyPlace::properties);
    definitions["properties"]["description"] = "Properties of an object. They stand in the place of those "
                                               "that its part has, each as a whole; false takes "
                                               "one away.";
    definitions["object"] = objectSchema(registry);
    definitions["placement"] = strictObject(
        {{"part", text}, {"at", reference("point")}, {"angle_deg", {{"type", "number"}}}}, {"part", "at"});
    definitions["input"] = inputSchema();
    definitions["change"] = changeSchema(registry);
    definitions["solution"] =
        strictObject({{"name", reference("name")},
                      {"placements", listOf(reference("placement"), limits::placements)},
                      {"inputs", listOf(reference("input"), limits::inputs)},
                      {"changes", listOf(reference("change"), limits::changes)},
                      {"expect", {{"enum", {"solved", "unsolved"}}}},
                      {"frames", {{"type", "integer"}, {"minimum", 1}, {"maximum", limits::frames}}}},
                     {"name"});
    Json members;
    members["version"] = Json{{"const", levelVersion}};
    members["title"] = reference("name");
    members["text"] = text;
    members["demonstration"] =
        Json{{"type", "boolean"}, {"description", "the level is meant to reach its goals with hands off"}};
    members["world"] = worldSchema(registry);
    members["objects"] = listOf(reference("object"), limits::objects);
    if (PropertyInfo const* const joint = registry.objectProperty("joint")) {
        definitions["joint"] = jointSchema(*joint);
        members["joints"] = listOf(reference("joint"), limits::joints);
    }
    members["connections"] = listOf(connectionSchema(registry), limits::connections);
    members["connections"]["description"] = "Pairs of objects that are connected from the start. A bare pair "
                                            "belongs to the effect that can connect "
                                            "the two; where several can, \"kind\" says which.";
    members["placing"] = listOf(reference("area"), limits::areas);
    members["placing"]["description"] = "Where the player may place; left out: anywhere within the bounds.";
    members["toolbox"] =
        listOf(strictObject({{"part", text}, {"count", count}}, {"part"}), limits::toolboxEntries);
    members["goals"] = goals.is_null() ? Json{{"type", "object"}} : reference("condition");
    members["hints"] = listOf(text, limits::hints);
    members["solutions"] = listOf(reference("solution"), limits::solutions);
    members["$schema"] = text;
    if (goals.is_object() && goals.contains("$defs")) {
        for (auto const& [name, definition] : goals["$defs"].items()) {
            definitions[name] = definition;
        }
    }
    Json schema{
        {"$schema", draft},
        {"title", "A level of Trembler"},
        {"description",
         fmt::format("Generated by `trembler schema`. SI units; angles in degrees where the key says so; y "
                     "up. The order of entries in lists never matters to the simulation. A file has at "
                     "most {} bytes and {} values, and {} lists and objects inside one another.",
                     limits::fileSize, limits::values, limits::depth)}};
    schema.update(strictObject(std::move(members), {"version", "title"}));
    schema["$defs"] = std::move(definitions);
    return schema;
}

Json partSchema(Registry const& registry) {
    Json const text{{"type", "string"}};
    Json definitions = commonDefinitions();
    definitions["properties"] = propertiesSchema(registry, PropertyPlace::properties);
    Json members{
        {"$schema", text}, {"name", reference("name")}, {"title", reference("name")}, {"text", text}};
    if (PropertyInfo const* const look = registry.objectProperty("look")) {
        members["look"] = propertySchema(*look);
    }
    members["properties"] = reference("properties");
    Json schema{{"$schema", draft}, {"title", "A part of Trembler"}};
    schema.update(strictObject(std::move(members), {"name"}));
    schema["$defs"] = std::move(definitions);
    return schema;
}

} // namespace trembler
