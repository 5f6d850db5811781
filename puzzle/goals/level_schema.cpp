#include "puzzle/goals/level_schema.hpp"

#include "puzzle/goals/conditions/table.hpp"
#include "puzzle/goals/judging/object_finder.hpp"
#include "puzzle/goals/reading/schema_pieces.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/schema_pieces.hpp"
#include "runtime/level/write/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace trembler {
namespace {

using Json = nlohmann::ordered_json;

/// The schema of a condition of one kind, with the members that every condition may have.
Json conditionSchema(std::string const& key, Json body) {
    Json members;
    members[key] = std::move(body);
    members["for"] = Json{{"type", "number"},
                          {"minimum", 0},
                          {"maximum", 3600},
                          {"description", "seconds for which it must hold without interruption"}};
    members["id"] = goal_schema::reference("name");
    members["text"] = json_schema::text();
    members["text"]["description"] = "text for the player; left out: made from the condition";
    return goal_schema::strictObject(std::move(members), {key});
}

/// The schemas of all kinds, in the order of the table, except that kinds with equal bodies follow one
/// another.
Json conditionSchemas() {
    std::vector<Json> bodies;
    std::vector<std::vector<std::string>> keys; // for each body
    for (ConditionKind const* const kind : conditionKinds()) {
        Json body = kind->schema();
        auto const known =
            static_cast<std::size_t>(std::find(bodies.begin(), bodies.end(), body) - bodies.begin());
        if (known == bodies.size()) {
            bodies.push_back(std::move(body));
            keys.emplace_back();
        }
        keys[known].emplace_back(kind->key());
    }
    Json all = Json::array();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::string const& key : keys[i]) {
            all.push_back(conditionSchema(key, bodies[i]));
        }
    }
    return all;
}

} // namespace

Json goalSchema() {
    Json const single{
        {"anyOf", Json::array({goal_schema::reference("name"),
                               goal_schema::strictObject({{"part", {{"type", "string"}}}}, {"part"})})}};
    Json definitions;
    definitions["selector"] =
        Json{{"anyOf", Json::array({single, goal_schema::listOf(single, limits::objects)})},
             {"description", "The name of an object, {\"part\": name} for any object made from that part, or "
                             "a list of these for any of them."}};
    definitions["condition"] = Json{
        {"oneOf", conditionSchemas()},
        {"description",
         fmt::format(
             "A condition on a world; a level has at most {} of them, including those inside others, and "
             "they are about at most {} objects in all, each counted for every condition about it.",
             limits::conditions, ObjectFinder::most)}};
    return Json{{"$ref", "#/$defs/condition"}, {"$defs", std::move(definitions)}};
}

Json levelSchema(Registry const& registry) {
    return levelSchema(registry, goalSchema());
}

} // namespace trembler
