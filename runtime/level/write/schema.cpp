#include "runtime/level/write/schema.hpp"

#include "runtime/input/player_input.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/schema_pieces.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_group.hpp"
#include "runtime/level/read/read_extensions.hpp"
#include "runtime/level/read/read_teaching.hpp"
#include "runtime/level/read/read_texts.hpp"
#include "runtime/level/write/change_schema.hpp"
#include "runtime/level/write/property_schema.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace trembler {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view draft = "https://json-schema.org/draft/2020-12/schema";

Json worldSchema(Registry const& registry) {
    Json world = propertiesSchema(registry, PropertyPlace::world);
    world["description"] = "The world as a whole.";
    world["properties"]["bounds"] = json_schema::reference("box");
    world["properties"]["detail"] = detailSchema(registry, false);
    world["properties"]["detail"]["description"] =
        "Detail level by effect; for an effect that is not stated, the scene determines it.";
    return world;
}

Json flippedSchema() {
    return Json{{"type", "boolean"},
                {"description", "whether it is mirrored about its own vertical axis, before it is turned"}};
}

Json objectSchema(Registry const& registry) {
    Json members{
        {"name", json_schema::reference("name")},
        {"part",
         {{"type", "string"}, {"description", "name of the part definition from which the object is made"}}}};
    Json const placement = propertiesSchema(registry, PropertyPlace::placement);
    for (auto const& [key, schema] : placement["properties"].items()) {
        members[key] = schema;
    }
    members["flipped"] = flippedSchema();
    members["properties"] = json_schema::reference("properties");
    members["pieces"] = Json{{"type", "object"},
                             {"additionalProperties", json_schema::reference("properties")},
                             {"description", "properties of pieces of a composite part, by the piece's name; "
                                             "\"properties\" are those of its main piece"}};
    return json_schema::strictObject(std::move(members), {"name"});
}

Json jointSchema(PropertyInfo const& info) {
    Json joint = fieldsSchema(info);
    joint["properties"]["name"] = json_schema::reference("name");
    return joint;
}

Json inputSchema() {
    Json const frame{
        {"type", "integer"},
        {"minimum", 1},
        {"maximum", limits::frames},
        {"description", "the frame in which the input takes effect, from 1 to the solution's last one"}};
    Json kinds = Json::array();
    std::map<std::string_view, Json> const bodies{{"grab", json_schema::reference("name")},
                                                  {"move", json_schema::reference("point")},
                                                  {"release", Json{{"const", true}}},
                                                  {"cut", Json{{"type", "array"},
                                                               {"items", json_schema::reference("name")},
                                                               {"minItems", 2},
                                                               {"maxItems", 2}}},
                                                  {"remove", json_schema::reference("name")}};
    for (std::string_view const kind : playerInputNames) {
        Json members{{"frame", frame}};
        members[std::string(kind)] = bodies.at(kind);
        std::vector<std::string> required{"frame", std::string(kind)};
        if (kind == "grab") {
            members["at"] = json_schema::reference("point");
            required.emplace_back("at");
        }
        if (kind == "grab" || kind == "move" || kind == "release") {
            members["hand"] = Json{{"enum", {0, 1}}, {"description", "which hand; 0 if left out"}};
        }
        kinds.push_back(json_schema::strictObject(std::move(members), required));
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
    Json polygon = json_schema::listOf(json_schema::reference("point"), limits::areaCorners);
    polygon["minItems"] = 3;
    definitions["area"] = Json{{"anyOf", Json::array({json_schema::reference("box"), std::move(polygon)})}};
    return definitions;
}

Json connectionSchema(Registry const& registry) {
    Json pair{{"type", "array"}, {"items", json_schema::reference("name")}, {"minItems", 2}, {"maxItems", 2}};
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
    Json stated = json_schema::strictObject(
        {{"between", pair}, {"kind", {{"enum", std::move(kinds)}, {"description", meanings}}}},
        {"between", "kind"});
    return Json{{"anyOf", Json::array({std::move(pair), std::move(stated)})}};
}

Json editorSchema() {
    Json const names = json_schema::listOf(json_schema::reference("name"), limits::objects);
    Json editor = json_schema::strictObject(
        {{"groups", json_schema::listOf(names, limits::objects)}, {"locked", names}, {"hidden", names}}, {});
    editor["description"] = "What the level editor keeps about objects: groups, which are selected together; "
                            "locked and hidden ones. No simulation reads it.";
    return editor;
}

} // namespace

Json levelSchema(Registry const& registry, Json const& goals) {
    Json const text = json_schema::text();
    Json const count{
        {"anyOf", Json::array({Json{{"type", "integer"}, {"minimum", 1}, {"maximum", limits::toolboxCount}},
                               Json{{"const", unlimitedWord}}})}};
    Json wire = count;
    wire["description"] = "how many wires the player may lay";
    Json definitions = commonDefinitions();
    definitions["properties"] = propertiesSchema(registry, PropertyPlace::properties);
    definitions["properties"]["description"] = "Properties of an object. Each replaces the whole property of "
                                               "the same name that its part has; false removes it.";
    definitions["object"] = objectSchema(registry);
    definitions["placement"] = json_schema::strictObject({{"part", text},
                                                          {"at", json_schema::reference("point")},
                                                          {"angle_deg", {{"type", "number"}}},
                                                          {"flipped", flippedSchema()}},
                                                         {"part", "at"});
    definitions["input"] = inputSchema();
    definitions["change"] = changeSchema(registry);
    definitions["solution"] = json_schema::strictObject(
        {{"name", json_schema::reference("name")},
         {"placements", json_schema::listOf(json_schema::reference("placement"), limits::placements)},
         {"wires", json_schema::listOf(Json{{"type", "array"},
                                            {"items", json_schema::reference("name")},
                                            {"minItems", 2},
                                            {"maxItems", 2}},
                                       limits::connections)},
         {"inputs", json_schema::listOf(json_schema::reference("input"), limits::inputs)},
         {"changes", json_schema::listOf(json_schema::reference("change"), limits::changes)},
         {"expect", {{"enum", {"solved", "unsolved"}}}},
         {"frames", {{"type", "integer"}, {"minimum", 1}, {"maximum", limits::frames}}}},
        {"name"});
    Json members;
    members["version"] = Json{{"const", levelVersion}};
    members["title"] = json_schema::reference("name");
    members["text"] = text;
    members["demonstration"] =
        Json{{"type", "boolean"},
             {"description", "whether the level is meant to reach its goals without any placement or input"}};
    members["mods"] = json_schema::listOf(json_schema::reference("name"), mostExtensions);
    members["mods"]["description"] = "Names of the mods that the level needs, each once.";
    members["world"] = worldSchema(registry);
    members["objects"] = json_schema::listOf(json_schema::reference("object"), limits::objects);
    members["objects"]["description"] =
        fmt::format("A world has at most {} objects and joints, with those that composite parts consist of. "
                    "Such a part consists of at most {}, and parts lie at most {} deep inside one another.",
                    limits::made, limits::pieces, limits::partDepth);
    if (PropertyInfo const* const joint = registry.objectProperty("joint")) {
        definitions["joint"] = jointSchema(*joint);
        members["joints"] = json_schema::listOf(json_schema::reference("joint"), limits::joints);
    }
    members["connections"] = json_schema::listOf(connectionSchema(registry), limits::connections);
    members["connections"]["description"] =
        "Pairs of objects that are connected from the start. A pair without \"kind\" is connected by the "
        "effect that can connect the two; if several can, \"kind\" must be stated.";
    members["placing"] = json_schema::listOf(json_schema::reference("area"), limits::areas);
    members["placing"]["description"] =
        "The areas in which the player may place parts; left out: anywhere within the bounds.";
    members["toolbox"] = json_schema::listOf(
        Json{{"anyOf", Json::array({json_schema::strictObject({{"part", text}, {"count", count}}, {"part"}),
                                    json_schema::strictObject({{"wire", wire}}, {"wire"})})}},
        limits::toolboxEntries);
    members["goals"] = goals.is_null() ? Json{{"type", "object"}} : json_schema::reference("condition");
    members["task"] = members["goals"];
    members["hints"] = json_schema::listOf(text, limits::hints);
    members["teaching"] = teachingSchema();
    members["texts"] = textsSchema(TextsOf::level);
    members["solutions"] = json_schema::listOf(json_schema::reference("solution"), limits::solutions);
    members["editor"] = editorSchema();
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
         fmt::format(
             "Generated by `trembler schema`. SI units; angles are in degrees, which the keys state; the y "
             "axis points up. The simulation does not depend on the order of entries in lists. A file has at "
             "most {} bytes and {} values, and {} lists and objects inside one another.",
             limits::fileSize, limits::values, limits::depth)}};
    schema.update(json_schema::strictObject(std::move(members), {"version", "title"}));
    schema["$defs"] = std::move(definitions);
    return schema;
}

Json partSchema(Registry const& registry) {
    Json const text = json_schema::text();
    Json definitions = commonDefinitions();
    definitions["properties"] = propertiesSchema(registry, PropertyPlace::properties);
    Json members{{"$schema", text},
                 {"name", json_schema::reference("name")},
                 {"title", json_schema::reference("name")},
                 {"text", text},
                 {"texts", textsSchema(TextsOf::part)}};
    members["groups"] = json_schema::listOf(Json{{"enum", partGroupNames}}, partGroupNames.size());
    members["groups"]["description"] =
        "The groups of a large toolbox that have the part; left out: those that follow from its properties.";
    if (PropertyInfo const* const look = registry.objectProperty("look")) {
        members["look"] = propertySchema(*look);
    }
    members["properties"] = json_schema::reference("properties");
    members["objects"] = json_schema::listOf(json_schema::reference("object"), limits::pieces);
    members["objects"]["description"] = "The pieces of a composite part.";
    definitions["object"] = objectSchema(registry);
    if (PropertyInfo const* const joint = registry.objectProperty("joint")) {
        definitions["joint"] = jointSchema(*joint);
        members["joints"] = json_schema::listOf(json_schema::reference("joint"), limits::pieces);
    }
    members["connections"] = json_schema::listOf(connectionSchema(registry), limits::connections);
    members["main"] = json_schema::reference("name");
    members["main"]["description"] = "The piece that the part's name refers to; left out: the first.";
    Json schema{{"$schema", draft}, {"title", "A part of Trembler"}};
    schema.update(json_schema::strictObject(std::move(members), {"name"}));
    schema["$defs"] = std::move(definitions);
    return schema;
}

} // namespace trembler
