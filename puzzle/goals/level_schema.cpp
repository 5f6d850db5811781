#include "puzzle/goals/level_schema.hpp"

#include "runtime/level/json/limits.hpp"
#include "runtime/level/write/schema.hpp"

#include <fmt/format.h>

#include <vector>

namespace trembler {
namespace {

using Json = nlohmann::ordered_json;

Json reference(std::string_view name) {
    return Json{{"$ref", fmt::format("#/$defs/{}", name)}};
}

Json strictObject(Json properties, std::vector<std::string> const& required) {
    return Json{{"type", "object"},
                {"properties", std::move(properties)},
                {"additionalProperties", false},
                {"required", required}};
}

Json listOf(Json items, std::size_t most) {
    return Json{{"type", "array"}, {"items", std::move(items)}, {"minItems", 1}, {"maxItems", most}};
}

/// A condition of one kind, with what every condition can have besides.
Json kind(std::string const& key, Json body) {
    Json members;
    members[key] = std::move(body);
    members["for"] = Json{{"type", "number"},
                          {"minimum", 0},
                          {"maximum", 3600},
                          {"description", "seconds that it must hold without a break"}};
    members["id"] = reference("name");
    members["text"] =
        Json{{"type", "string"}, {"description", "what the player reads; left out: made from the condition"}};
    return strictObject(std::move(members), {key});
}

Json count() {
    Json members{{"of", reference("selector")}, {"that", reference("condition")}};
    for (char const* const quantity : {"at_least", "at_most", "exactly"}) {
        members[quantity] = Json{{"type", "integer"}, {"minimum", 0}, {"maximum", 100000}};
    }
    Json body = strictObject(std::move(members), {"of", "that"});
    body["minProperties"] = 3;
    body["maxProperties"] = 3;
    body["description"] = "For how many objects the condition \"that\" holds; there \"it\" is the object.";
    return body;
}

} // namespace

Json goalSchema() {
    Json const selector = reference("selector");
    Json const single{{"anyOf", Json::array({reference("name"),
                                             strictObject({{"part", {{"type", "string"}}}}, {"part"})})}};
    Json definitions;
    definitions["selector"] =
        Json{{"anyOf", Json::array({single, listOf(single, limits::objects)})},
             {"description",
              "The name of an object, {\"part\": name} for anything made from that part, or a list of "
              "these: any of them."}};
    Json const distance{{"type", "number"}, {"minimum", 1e-3}, {"maximum", 1e6}, {"description", "m"}};
    Json const inside =
        strictObject({{"object", selector},
                      {"area", reference("area")},
                      {"called", {{"type", "string"}, {"description", "words for the area"}}}},
                     {"object", "area"});
    Json const moved = strictObject(
        {{"object", selector}, {"by", distance}, {"towards", {{"enum", {"up", "down", "left", "right"}}}}},
        {"object", "by"});
    Json const pair{{"type", "array"}, {"items", selector}, {"minItems", 2}, {"maxItems", 2}};
    Json const conditions = listOf(reference("condition"), limits::conditions);
    definitions["condition"] =
        Json{{"oneOf", Json::array({kind("inside", inside), kind("touching", pair), kind("on", selector),
                                    kind("off", selector), kind("moved", moved), kind("count", count()),
                                    kind("all", conditions), kind("any", conditions),
                                    kind("sequence", conditions), kind("not", reference("condition"))})},
             {"description",
              fmt::format("Something that can hold in a world, or not; at most {} of them in a level, one "
                          "inside another included.",
                          limits::conditions)}};
    return Json{{"$ref", "#/$defs/condition"}, {"$defs", std::move(definitions)}};
}

Json levelSchema(Registry const& registry) {
    return levelSchema(registry, goalSchema());
}

} // namespace trembler
