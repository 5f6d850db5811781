// Levels that state n of something, for the growth bench: one for everything that a level can state in
// number.
#pragma once

#include "runtime/level/json/limits.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace bench {

using Json = nlohmann::json;

/// Frames that are measured after the first one.
constexpr int framesOfGrowth = 5;

/// Parts that stand by themselves.
constexpr std::array<char const*, 10> placed{"crate",        "brick",     "block",       "plank",
                                             "steel ball",   "iron ball", "rubber ball", "wooden ball",
                                             "wooden wedge", "wooden bar"};

inline Json level(std::string const& title) {
    return Json{{"version", 1},
                {"title", title},
                {"world", {{"gravity", {0, -9.81}}}},
                {"objects", Json::array()},
                {"joints", Json::array()},
                {"connections", Json::array()}};
}

inline Json box(double width, double height) {
    return Json::array({{{"form", "box"}, {"width", width}, {"height", height}}});
}

inline std::string numbered(char const* word, int number) {
    return fmt::format("{} {}", word, number);
}

inline void add(Json& level, std::string const& name, double x, double y, Json properties) {
    level["objects"].push_back({{"name", name}, {"at", {x, y}}, {"properties", std::move(properties)}});
}

inline void addFloor(Json& level, double length) {
    constexpr double piece = 500;
    for (int i = 0; piece * i < length; ++i) {
        add(level, numbered("floor", i), piece * (i + 0.5) - 10, -0.5,
            {{"shape", box(piece, 1)}, {"fixed", true}});
    }
}

/// A row of boxes of 0.5 m, `gap` m apart, `height` m above a floor.
inline Json row(int n, double gap, double height) {
    Json made = level("row");
    addFloor(made, n * (0.5 + gap) + 20);
    for (int i = 0; i < n; ++i) {
        add(made, numbered("box", i), i * (0.5 + gap), 0.25 + height, {{"shape", box(0.5, 0.5)}});
    }
    return made;
}

/// n conductors on one cable from a source to a return.
inline Json cable(int n) {
    Json made = level("cable");
    add(made, "source", -1, 0, {{"conductor", true}, {"electrical_source", true}});
    for (int i = 0; i < n; ++i) {
        add(made, numbered("wire", i), i, 0, {{"conductor", true}});
    }
    add(made, "return", n, 0, {{"conductor", true}, {"electrical_return", true}});
    std::string last = "source";
    for (int i = 0; i <= n; ++i) {
        std::string const next = i == n ? "return" : numbered("wire", i);
        made["connections"].push_back({last, next});
        last = next;
    }
    return made;
}

inline Json twoBodies() {
    Json made = level("two bodies");
    add(made, "a", 0, 0, {{"shape", box(0.5, 0.5)}});
    add(made, "b", 1, 0, {{"shape", box(0.5, 0.5)}});
    return made;
}

/// Things in a square lattice, `apart` m.
inline Json lattice(int n, double apart, Json const& properties) {
    Json made = level("lattice");
    int const side = static_cast<int>(std::ceil(std::sqrt(n)));
    for (int i = 0; i < n; ++i) {
        add(made, numbered("thing", i), apart * (i % side), apart * static_cast<double>(i / side),
            properties);
    }
    return made;
}

/// Something that a level can state in number.
struct GrowthRow {
    std::string key;
    std::string what;
    std::function<Json(int)> make;
    /// Whether the level is refused, and this is what is measured.
    bool refused = false;
    /// More of it than a level may hold.
    std::size_t most = 1000000;
    /// Above these exponents the bench fails. Where one is greater than usual,
    /// docs/measurements/performance.md says why.
    double mostOfLoad = 1.25;
    double mostOfFrame = 1.25;
};

inline Json parallel(int n, char const* form) {
    Json made = twoBodies();
    for (int i = 0; i < n; ++i) {
        made["joints"].push_back({{"form", form},
                                  {"a", "a"},
                                  {"b", "b"},
                                  {"at", {0.4, 0}},
                                  {"at_b", {0.6, 0}},
                                  {"stiffness", 10}});
    }
    return made;
}

inline Json hinges(int n) {
    Json made = level("chain");
    for (int i = 0; i <= n; ++i) {
        add(made, numbered("link", i), i, 0, {{"shape", box(0.9, 0.1)}, {"collision", {{"mask", 0}}}});
    }
    for (int i = 0; i < n; ++i) {
        made["joints"].push_back({{"form", "hinge"},
                                  {"a", numbered("link", i)},
                                  {"b", numbered("link", i + 1)},
                                  {"at", {i + 0.5, 0}}});
    }
    return made;
}

inline Json cuts(int n) {
    Json made = cable(n);
    Json inputs = Json::array();
    for (int frame = 1; frame <= framesOfGrowth + 1; ++frame) {
        int const at = n / 2 + frame;
        inputs.push_back({{"frame", frame}, {"cut", {numbered("wire", at), numbered("wire", at + 1)}}});
    }
    made["solutions"] = {{{"name", "cut"}, {"inputs", inputs}}};
    return made;
}

inline Json refusedPlacements(int n) {
    Json made = twoBodies();
    made["toolbox"] = {{{"part", "crate"}}};
    Json placements = Json::array();
    for (int i = 0; i < n; ++i) {
        placements.push_back({{"part", "crate"}, {"at", {0.001 * i, 5}}});
    }
    made["solutions"] = {{{"name", "many"}, {"placements", placements}}};
    return made;
}

inline Json refusedConnections(int n) {
    Json made = cable(n);
    for (Json& connection : made["connections"]) {
        connection[1] = "nothing " + connection[1].get<std::string>();
    }
    return made;
}

inline Json solutions(int n) {
    Json made = lattice(n, 1, Json::object());
    made["solutions"] = Json::array();
    for (int i = 0; i < n; ++i) {
        made["solutions"].push_back(
            {{"name", numbered("solution", i)},
             {"inputs", {{{"frame", 1}, {"grab", numbered("thing", i)}, {"at", {0, 0}}}}}});
    }
    return made;
}

inline Json inputs(int n) {
    Json made = twoBodies();
    Json all = Json::array();
    for (int i = 0; i < n; ++i) {
        all.push_back({{"frame", 1 + i}, {"move", {0, 0}}});
    }
    made["solutions"] = {{{"name", "moves"}, {"inputs", all}}};
    return made;
}

inline Json goals(int n) {
    Json made = lattice(n, 2, {{"shape", box(0.5, 0.5)}});
    Json all = Json::array();
    for (int i = 1; i < n; ++i) { // "all" is one itself
        all.push_back({{"moved", {{"object", numbered("thing", i)}, {"by", 1000}}}});
    }
    made["goals"] = {{"all", all}};
    return made;
}

inline Json touchGoal(int n) {
    Json made = row(n, 0.5, 0);
    Json boxes = Json::array();
    for (int i = 0; i < n; ++i) {
        boxes.push_back(numbered("box", i));
    }
    made["goals"] = {{"touching", {boxes, boxes}}};
    return made;
}

inline Json floats(int n) {
    Json made = level("sea");
    constexpr double piece = 1000;
    for (int i = 0; piece * i < 2 * n + 20; ++i) {
        add(made, numbered("sea", i), piece * (i + 0.5) - 10, -5,
            {{"shape", box(piece, 10)}, {"liquid", true}, {"density", 1000}});
    }
    for (int i = 0; i < n; ++i) {
        add(made, numbered("float", i), 2 * i, 0, {{"shape", box(0.5, 0.5)}, {"density", 500}});
    }
    return made;
}

inline Json pools(int n) {
    Json made = level("pools");
    for (int i = 0; i < n; ++i) {
        add(made, numbered("pool", i), 2 * i, -5,
            {{"shape", box(1, 10)}, {"liquid", true}, {"density", 1000}});
        add(made, numbered("float", i), 2 * i, 0, {{"shape", box(0.5, 0.5)}, {"density", 500}});
    }
    return made;
}

inline Json lamps(int n) {
    Json made = level("lamps");
    add(made, "source", 0, 0, {{"conductor", true}, {"electrical_source", true}, {"emf", {{"voltage", 10}}}});
    add(made, "return", 2, 0, {{"conductor", true}, {"electrical_return", true}});
    for (int i = 0; i < n; ++i) {
        add(made, numbered("lamp", i), i, 5,
            {{"conductor", true}, {"electrical_device", true}, {"resistance", 100}});
        made["connections"].push_back({"source", numbered("lamp", i)});
        made["connections"].push_back({numbered("lamp", i), "return"});
    }
    return made;
}

/// Parts out of the toolbox, each in a place where it is free. A part is there a thousand times at most.
inline Json placements(int n) {
    Json made = level("placed");
    made["toolbox"] = Json::array();
    Json all = Json::array();
    int const side = static_cast<int>(std::ceil(std::sqrt(n)));
    for (int i = 0; i < n; ++i) {
        std::string const part =
            placed.at(static_cast<std::size_t>(i) / static_cast<std::size_t>(trembler::limits::toolboxCount));
        if (i % static_cast<int>(trembler::limits::toolboxCount) == 0) {
            made["toolbox"].push_back({{"part", part}, {"count", trembler::limits::toolboxCount}});
        }
        all.push_back({{"part", part}, {"at", {3 * (i % side), 3 * (i / side)}}});
    }
    made["solutions"] = {{{"name", "many"}, {"placements", all}}};
    return made;
}

/// Bodies that each hang from a joint of their own on one that is fixed.
inline Json ownJoints(int n, char const* form, double breakForce) {
    Json made = level("joints");
    for (int i = 0; i < n; ++i) {
        add(made, numbered("peg", i), 2 * i, 1, {{"shape", box(0.1, 0.1)}, {"fixed", true}});
        add(made, numbered("bob", i), 2 * i, 0, {{"shape", box(0.5, 0.5)}});
        Json joint{{"form", form},
                   {"a", numbered("peg", i)},
                   {"b", numbered("bob", i)},
                   {"at", {2 * i, 1}},
                   {"stiffness", 100}};
        if (breakForce > 0) {
            joint["break_force"] = breakForce;
        }
        made["joints"].push_back(std::move(joint));
    }
    return made;
}

inline Json atOnce(Json made, char const* kind, std::function<Json(int)> const& what, int n) {
    Json inputs = Json::array();
    for (int i = 0; i < n; ++i) {
        inputs.push_back({{"frame", 3}, {kind, what(i)}});
    }
    made["solutions"] = {{{"name", "at once"}, {"inputs", inputs}}};
    return made;
}

inline Json cutsAtOnce(int n) {
    return atOnce(
        cable(n), "cut",
        [](int i) {
            return i == 0 ? Json{"source", "wire 0"} : Json{numbered("wire", i - 1), numbered("wire", i)};
        },
        n);
}

inline Json repeatedConnections(int n) {
    Json made = cable(1);
    for (int i = 0; i < n; ++i) {
        made["connections"].push_back({"source", "wire 0"});
    }
    return made;
}

/// Stacks of ten boxes.
inline Json stacks(int n) {
    Json made = level("stacks");
    addFloor(made, n * 0.1 + 20);
    for (int i = 0; i < n; ++i) {
        add(made, numbered("box", i), i / 10, 0.25 + 0.5 * (i % 10), {{"shape", box(0.5, 0.5)}});
    }
    return made;
}

/// Bodies in one place, each inside of all others.
inline Json crowd(int n) {
    Json made = level("crowd");
    for (int i = 0; i < n; ++i) {
        add(made, numbered("box", i), 0, 0, {{"shape", box(0.5, 0.5)}});
    }
    return made;
}

inline Json overlappingPools(int n) {
    Json made = level("pools");
    for (int i = 0; i < n; ++i) {
        add(made, numbered("pool", i), 0, 0, {{"shape", box(1, 1)}, {"liquid", true}, {"density", 1000}});
    }
    return made;
}

inline Json masses(int n) {
    Json made = lattice(n, 20, {{"shape", box(1, 1)}, {"density", 1e5}});
    made["world"] = {{"gravity_law", true}};
    return made;
}

/// A square net of resistors between a source and a return.
inline Json net(int n) {
    Json made = level("net");
    int const side = std::max(2, static_cast<int>(std::sqrt(n)));
    add(made, "source", -1, 0,
        {{"conductor", true}, {"electrical_source", true}, {"emf", {{"voltage", 10}}}});
    add(made, "return", side, 0, {{"conductor", true}, {"electrical_return", true}});
    for (int i = 0; i < side * side; ++i) {
        add(made, numbered("node", i), i % side, i / side, {{"conductor", true}, {"resistance", 10}});
        if (i % side > 0) {
            made["connections"].push_back({numbered("node", i - 1), numbered("node", i)});
        }
        if (i >= side) {
            made["connections"].push_back({numbered("node", i - side), numbered("node", i)});
        }
    }
    made["world"]["detail"] = {{"electricity", "nodal"}};
    made["connections"].push_back({"source", "node 0"});
    made["connections"].push_back({numbered("node", side * side - 1), "return"});
    return made;
}

/// Motors that turn, all on one source.
inline Json motors(int n) {
    Json made = level("motors");
    add(made, "source", 0, 0, {{"conductor", true}, {"electrical_source", true}});
    add(made, "return", 2, 0, {{"conductor", true}, {"electrical_return", true}});
    for (int i = 0; i < n; ++i) {
        add(made, numbered("rotor", i), 2 * i, 5,
            {{"shape", box(0.5, 0.1)},
             {"conductor", true},
             {"electrical_device", true},
             {"electric_motor", {{"torque", 10}, {"idle_speed_deg", 300}}}});
        made["connections"].push_back({"source", numbered("rotor", i)});
        made["connections"].push_back({numbered("rotor", i), "return"});
        made["joints"].push_back({{"form", "hinge"}, {"a", numbered("rotor", i)}, {"at", {2 * i, 5}}});
    }
    return made;
}

/// Boxes of steel that land in one frame, heard.
inline Json heard(int n, int ears) {
    Json made = row(n, 0.5, 0.01);
    for (Json& object : made["objects"]) {
        if (!object["properties"].contains("fixed")) {
            object["properties"]["material"] = "steel";
            object["properties"]["velocity"] = {0, -2};
        }
    }
    for (int i = 0; i < ears; ++i) {
        add(made, numbered("ear", i), i, 1, {{"ear", true}});
    }
    return made;
}

inline std::vector<GrowthRow> growthRows() {
    Json const crate{{"shape", box(0.5, 0.5)}};
    Json const magnet{{"shape", box(0.2, 0.05)},
                      {"magnetic_poles", {{"poles", "both"}, {"north", {0.1, 0}}, {"south", {-0.1, 0}}}},
                      {"magnetic_strength", {{"strength", 10}}},
                      {"magnet", true}};
    return {
        {"objects", "objects without a body", [](int n) { return lattice(n, 1, Json::object()); }},
        {"falling", "boxes that fall", [=](int n) { return lattice(n, 2, crate); }},
        {"rest", "boxes side by side, at rest", [](int n) { return row(n, 0.5, 0); }},
        {"touching", "boxes in a row, each touching the next", [](int n) { return row(n, 0, 0); }},
        {"landing", "boxes that land in one frame", [](int n) { return row(n, 0.5, 0.01); }},
        {"stacks", "boxes in stacks of ten", stacks},
        {"crowd", "boxes in one place", crowd, false, 1000000, 2.2, 2.2},   // n²/2 pairs
        {"chain", "hinges of a chain", hinges, false, 1000000, 1.25, 1.75}, // and more substeps
        {"chain-4", "the same in four substeps",
         [](int n) {
             Json made = hinges(n);
             made["world"]["solver"] = {{"substeps", 4}};
             return made;
         },
         false, 1000000, 1.25, 1.35},
        {"own-hinges", "pendulums", [](int n) { return ownJoints(n, "hinge", 0); }},
        {"own-springs", "bodies on springs", [](int n) { return ownJoints(n, "spring", 0); }},
        {"breaking", "hinges that all break in one frame", [](int n) { return ownJoints(n, "hinge", 0.01); }},
        {"parallel-hinges", "hinges between two bodies", [](int n) { return parallel(n, "hinge"); }},
        {"parallel-springs", "springs between two bodies", [](int n) { return parallel(n, "spring"); }},
        {"connections", "connections of a cable", cable},
        {"cuts", "the same, one cut in each frame", cuts},
        {"cuts-at-once", "the same, all cut in one frame", cutsAtOnce},
        {"repeated-connections", "one connection, stated n times, refused", repeatedConnections, true},
        {"lamps", "lamps in parallel, nodal", lamps},
        {"net", "a square net of resistors, nodal", net},
        {"motors", "motors at work", motors},
        {"magnets", "magnets", [=](int n) { return lattice(n, 1, magnet); }},
        {"floats", "boxes afloat", floats},
        {"pools", "pools, a box in each", pools},
        {"overlapping-pools", "pools in one place, refused", overlappingPools, true},
        {"masses", "masses that attract each other", masses},
        {"heard", "boxes that land in one frame, for an ear", [](int n) { return heard(n, 1); }},
        {"ears", "ears, ten boxes land", [](int n) { return heard(10, n); }},
        {"sounds-and-ears", "boxes that land, and as many ears", [](int n) { return heard(n, n); }, false,
         trembler::limits::objects / 2 - 1000, 1.25, 2.2}, // sounds times ears
        {"goals", "goals, each about a body of its own", goals, false, trembler::limits::conditions},
        {"touch-goal", "boxes in a goal that any two of them touch", touchGoal},
        {"solutions", "solutions", solutions, false, trembler::limits::solutions},
        {"inputs", "inputs of a solution", inputs},
        {"placements", "placements", placements, false, placed.size() * trembler::limits::toolboxCount},
        {"removed", "boxes that the player removes in one frame",
         [=](int n) {
             return atOnce(
                 lattice(n, 2, crate), "remove", [](int i) { return numbered("thing", i); }, n);
         }},
        {"removed-fixed", "fixed boxes that the player removes in one frame",
         [=](int n) {
             Json fixed = crate;
             fixed["fixed"] = true;
             return atOnce(
                 lattice(n, 2, fixed), "remove", [](int i) { return numbered("thing", i); }, n);
         }},
        {"refused-placements", "placements, all but one refused", refusedPlacements, true,
         trembler::limits::placements},
        {"refused-connections", "connections to nothing, all refused", refusedConnections, true, 1000000,
         1.4}, // for the first hundred, all names are looked through
    };
}

} // namespace bench
