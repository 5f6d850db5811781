#include "tests/worlds/random_level.hpp"

#include "tests/worlds/draw.hpp"

#include <algorithm>
#include <set>

namespace trembler::worlds {
namespace {

using Json = nlohmann::json;

/// The probabilities of properties that activate an effect; all others have the manner's.
double shareOf(std::string const& key, Manner const& manner) {
    if (key == "shape") {
        return 0.92;
    }
    if (key == "fixed") {
        return 0.15;
    }
    if (key == "joint") { // joints have a separate list
        return 0;
    }
    if (key == "liquid") {
        return manner.properties / 4;
    }
    if (key == "conductor" || key == "electrical_source" || key == "electrical_return") {
        return 2 * manner.properties;
    }
    return manner.properties;
}

Json objectOf(Draw& draw, Json const& definitions, Manner const& manner, std::string const& name) {
    Json made{{"name", name}, {"at", draw.place()}};
    if (draw.chance(0.7)) {
        made["angle_deg"] = draw.unit() * 360;
    }
    if (draw.chance(0.2)) {
        made["part"] = draw.value({{"type", "string"}}, "part");
    }
    Json properties = Json::object();
    bool const part = made.contains("part");
    for (auto const& [key, schema] : definitions.at("properties").at("properties").items()) {
        if (draw.chance(shareOf(key, manner) * (part ? 0.3 : 1))) {
            properties[key] = draw.value(schema, key);
        }
    }
    // Mass and density are alternatives; a liquid cannot have a mass.
    if (properties.contains("mass") && properties.contains("density")) {
        properties.erase("mass");
    }
    made["properties"] = std::move(properties);
    for (auto const& [key, schema] : definitions.at("object").at("properties").items()) {
        if (key != "name" && key != "part" && key != "at" && key != "angle_deg" && key != "properties" &&
            key != "pieces" && // of composite parts, of which these levels have none
            draw.chance(manner.properties)) {
            made[key] = draw.value(schema, key);
        }
    }
    return made;
}

Json floorOf(Manner const& manner) {
    return Json{{"name", "floor"},
                {"at", {0, -manner.spread - 0.5}},
                {"properties",
                 {{"shape", {{{"form", "box"}, {"width", 2 * manner.spread + 4}, {"height", 1}}}},
                  {"fixed", true},
                  {"conductor", true}}}};
}

void addJoints(Json& level, Draw& draw, Json const& schema, int count) {
    for (int i = 0; i < count; ++i) {
        Json joint = draw.joint(schema);
        std::string const name = "tie " + std::to_string(i);
        if (joint["form"] == "gear") { // its objects follow from the joints that it couples
            for (Json const& other : level["joints"]) {
                if (other["name"] == joint["joint_a"]) {
                    joint["a"] = other["a"];
                } else if (other["name"] == joint["joint_b"]) {
                    joint["b"] = other["a"];
                }
            }
        } else if (joint["form"] == "hinge" || joint["form"] == "slider") {
            draw.couplings.push_back(name);
        }
        joint["name"] = name;
        level["joints"].push_back(std::move(joint));
    }
}

void addConnections(Json& level, Draw& draw, Json const& schema, std::size_t count) {
    std::set<std::pair<std::string, std::string>> known;
    for (std::size_t i = 0; i < count && draw.objects.size() > 1; ++i) {
        std::string a = draw.oneOf(draw.objects);
        std::string b = draw.oneOf(draw.objects);
        if (a != b && known.insert(std::minmax(a, b)).second) {
            Json connection = draw.value(schema, "connections");
            (connection.is_object() ? connection["between"] : connection) = Json::array({a, b});
            level["connections"].push_back(std::move(connection));
        }
    }
}

void addSolution(Json& level, Draw& draw, Json const& definitions) {
    Json solution = draw.object(definitions.at("solution"), 0.6);
    solution["name"] = "some";
    solution.erase("expect");
    solution.erase("frames");
    level["solutions"] = Json::array({std::move(solution)});
}

} // namespace

Manner mannerOf(std::uint64_t seed) {
    Manner manner;
    switch (seed % 8) {
    case 0: // all numbers ordinary
        return {.extremes = 0, .anywhere = 0};
    case 1: // one or two numbers are not ordinary
        return {.extremes = 0.01, .anywhere = 0.01};
    case 2:
        return {.extremes = 0.3, .anywhere = 0.3};
    case 3: // crowded
        return {.extremes = 0.02, .anywhere = 0.02, .objects = 20, .joints = 20, .spread = 0.8};
    case 4: // all in one place
        return {.extremes = 0.02, .anywhere = 0.02, .objects = 8, .joints = 8, .spread = 0};
    case 5:
        manner.objects = 40;
        manner.manyOfOne = true;
        manner.spread = 3;
        return manner;
    case 6: // mostly joints
        return {
            .extremes = 0.03, .anywhere = 0.05, .objects = 5, .joints = 25, .spread = 2, .properties = 0.05};
    default: // objects of every effect
        return {.extremes = 0.03, .anywhere = 0.05, .objects = 14, .joints = 3, .properties = 0.5};
    }
}

RandomLevels::RandomLevels(Json schema, std::vector<std::string> parts)
    : schema_(std::move(schema)), parts_(std::move(parts)) {}

Json RandomLevels::make(std::uint64_t seed, Manner const& manner) const {
    Draw draw(schema_, parts_, manner, seed);
    Json const& definitions = schema_.at("$defs");
    Json const& members = schema_.at("properties");
    Json level{{"version", members.at("version").at("const")}, {"title", "seed " + std::to_string(seed)}};
    level["objects"] = Json::array({floorOf(manner)});
    level["joints"] = Json::array();
    level["connections"] = Json::array();
    for (int i = 0; i < manner.objects; ++i) {
        draw.objects.push_back("thing " + std::to_string(i));
    }
    Json first;
    for (std::string const& name : draw.objects) {
        if (!manner.manyOfOne || first.is_null()) {
            first = objectOf(draw, definitions, manner, name);
        }
        Json object = first;
        object["name"] = name;
        if (manner.manyOfOne) {
            object["at"] = draw.place();
        }
        level["objects"].push_back(std::move(object));
    }
    level["world"] = draw.object(members.at("world"), 0.4);
    if (draw.chance(0.8)) {
        level["world"]["gravity"] = {0, -9.81};
    }
    addJoints(level, draw, definitions.at("joint"), manner.joints);
    addConnections(level, draw, members.at("connections").at("items"), draw.objects.size());
    if (draw.chance(0.7)) {
        level["goals"] = draw.value(members.at("goals"), "goals");
    }
    level["toolbox"] = Json::array();
    for (std::string const& part : parts_) {
        level["toolbox"].push_back({{"part", part}, {"count", 1000}});
    }
    if (draw.chance(0.7)) {
        addSolution(level, draw, definitions);
    }
    return level;
}

std::vector<Json> RandomLevels::boundaries() const {
    Manner const manner{
        .extremes = 0, .anywhere = 0, .objects = 4, .joints = 0, .spread = 2, .properties = 0};
    std::vector<Json> levels;
    Json const& definitions = schema_.at("$defs");
    Json const base = [&] {
        Json level = make(1, manner);
        level.erase("solutions");
        level.erase("goals");
        level["world"] = Json{{"gravity", {0, -9.81}}};
        return level;
    }();
    auto const add = [&](Json const& schema, std::string const& key, auto const& put) {
        for (std::size_t number = 0, count = 1; number < count; ++number) {
            for (bool const high : {false, true}) {
                Draw draw(schema_, parts_, manner, 7);
                draw.objects = {"thing 0", "thing 1"};
                draw.couplings = {"tie 0", "tie 1"};
                draw.spike = Draw::Spike{number, high};
                Json level = base;
                level["title"] = key + " " + std::to_string(number) + (high ? " high" : " low");
                put(level, key == "joint" ? draw.object(schema, 1) : draw.value(schema, key));
                count = draw.numbers();
                levels.push_back(std::move(level));
            }
        }
    };
    for (auto const& [key, schema] : definitions.at("properties").at("properties").items()) {
        if (key != "shape" && key != "joint") {
            add(schema, key, [&, name = key](Json& level, Json value) {
                level["objects"][1]["properties"][name] = std::move(value);
            });
        }
    }
    for (auto const& [key, schema] : schema_.at("properties").at("world").at("properties").items()) {
        if (key != "detail") {
            add(schema, key,
                [&, name = key](Json& level, Json value) { level["world"][name] = std::move(value); });
        }
    }
    for (Json const& form : definitions.at("joint").at("properties").at("form").at("enum")) {
        add(definitions.at("joint"), "joint", [&](Json& level, Json value) {
            value["form"] = form;
            value["a"] = "thing 0";
            value["b"] = "thing 1";
            value["name"] = "tie";
            if (form != "gear") {
                value.erase("joint_a");
                value.erase("joint_b");
            }
            level["joints"] =
                Json::array({{{"name", "tie 0"}, {"form", "hinge"}, {"a", "thing 0"}, {"at", {0, 0}}},
                             {{"name", "tie 1"}, {"form", "slider"}, {"a", "thing 1"}, {"axis", {1, 0}}},
                             std::move(value)});
            if (form != "gear") {
                level["joints"] = Json::array({level["joints"][2]});
            }
        });
    }
    return levels;
}

bool takeAway(Json& level, std::string const& path) {
    std::vector<std::string> tokens;
    for (Json::json_pointer at(path); !at.empty(); at.pop_back()) {
        tokens.insert(tokens.begin(), at.back());
    }
    if (tokens.empty()) {
        return false;
    }
    // The length of the path to the removed value: an entry of a list, or one member of an object of the
    // level.
    std::size_t depth = std::min<std::size_t>(2, tokens.size());
    if (tokens[0] == "objects" && tokens.size() > 2) {
        depth = tokens[2] == "properties" && tokens.size() > 3 ? 4 : 3;
    } else if (tokens[0] == "solutions" && tokens.size() > 3) {
        depth = 4;
    } else if (tokens[0] == "goals") {
        depth = 1;
    }
    std::string parent;
    for (std::size_t i = 0; i + 1 < depth; ++i) {
        parent += "/" + tokens[i];
    }
    Json::json_pointer const owner(parent);
    if (!level.contains(owner)) {
        return false;
    }
    Json& around = level[owner];
    std::string const& last = tokens[depth - 1];
    if (around.is_object()) {
        return around.erase(last) > 0;
    }
    if (around.is_array()) {
        std::size_t const index = std::stoul(last);
        if (index < around.size()) {
            around.erase(index);
            return true;
        }
    }
    return false;
}

} // namespace trembler::worlds
