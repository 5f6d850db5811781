// The rows of bench_growth: a level for each thing that a level can contain in any number.
#pragma once

#include "bench/growth_levels/bodies.hpp"
#include "bench/growth_levels/circuits.hpp"
#include "bench/growth_levels/devices.hpp"
#include "bench/growth_levels/mechanisms.hpp"
#include "bench/growth_levels/pieces.hpp"
#include "bench/growth_levels/play.hpp"
#include "runtime/level/json/limits.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace bench {

/// Something that a level can contain in any number.
struct GrowthRow {
    std::string key;
    std::string what;
    std::function<Json(int)> make;
    /// Whether the level is refused, so that only the refusal is measured.
    bool refused = false;
    /// The largest n to measure.
    std::size_t most = 1000000;
    /// The bench fails above these exponents. docs/measurements/performance.md explains those that are
    /// greater than usual.
    double mostOfLoad = 1.25;
    double mostOfFrame = 1.25;
};

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
        {"chain", "hinges of a chain", hinges, false, 1000000, 1.25, 1.75}, // more bodies and more substeps
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
        {"sliders", "bodies on sliders", [](int n) { return guided(n, "slider"); }},
        {"rods", "bodies on rods", [](int n) { return guided(n, "distance"); }},
        {"ropes", "bodies on ropes", [](int n) { return guided(n, "rope"); }},
        {"wheels", "bodies on wheels", [](int n) { return guided(n, "wheel"); }},
        {"pulleys", "pulleys", pulleys},
        {"gears", "gears in a row", gears, false, 1000000, 1.25, 1.4},
        {"pieces", "pieces of bodies that fall, a hundred each", piecesOfBodies},
        {"connections", "connections of a cable", cable},
        {"cuts", "the same, one cut in each frame", cuts},
        {"cuts-at-once", "the same, all cut in one frame", cutsAtOnce},
        {"repeated-connections", "one connection, stated n times, refused", repeatedConnections, true},
        {"lamps", "lamps in parallel, nodal", lamps},
        {"networks", "networks that share a wire, one cut in each frame",
         [](int n) { return networks(n, false); }, false, trembler::limits::objects / 3 - 1},
        {"networks-row", "the same, that share a row of wires", [](int n) { return networks(n, true); },
         false, trembler::limits::objects / 4 - 1},
        {"networks-nodal", "networks of three objects that share a wire, nodal, one cut in each frame",
         [](int n) { return ownNetworks(n, "nodal"); }, false, trembler::limits::objects / 3 - 1},
        {"networks-flow", "the same, flow", [](int n) { return ownNetworks(n, "flow"); }, false,
         trembler::limits::objects / 3 - 1},
        {"net", "a square net of resistors, nodal", net},
        {"motors", "motors at work", motors},
        {"fuses", "fuses that all blow", fuses},
        {"generators", "generators at work", generators, false, trembler::limits::objects / 3},
        {"sensors", "sound sensors, a box lands", sensors},
        {"magnets", "magnets", [=](int n) { return lattice(n, 1, magnet); }},
        {"floats", "boxes afloat", floats},
        {"pools", "pools, a box in each", pools},
        {"overlapping-pools", "pools in one place, refused", overlappingPools, true},
        {"masses", "masses that attract each other", masses},
        {"heard", "boxes that land in one frame, for an ear", [](int n) { return heard(n, 1); }},
        {"ears", "ears, ten boxes land", [](int n) { return heard(10, n); }},
        {"sounds-and-ears", "boxes that land, and as many ears", [](int n) { return heard(n, n); }, false,
         trembler::limits::objects / 2 - 1000, 1.25, 2.2}, // sounds times listeners
        {"goals", "goals, each about a body of its own", goals, false, trembler::limits::conditions},
        {"touch-goal", "boxes in a goal that any two of them touch", touchGoal},
        {"solutions", "solutions", solutions, false, trembler::limits::solutions},
        {"inputs", "inputs of a solution", inputs},
        {"changes", "changes of a setting", changes, false, trembler::limits::changes},
        {"placements", "placements", placements, false, placed.size() * trembler::limits::toolboxCount},
        {"areas", "the same, each in an area of its own", placementsInAreas, false, trembler::limits::areas},
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
         1.4}, // all names are searched for the first hundred
    };
}

} // namespace bench
