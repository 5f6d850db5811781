// Levels with n goals, solutions, placements or inputs of the player.
#pragma once

#include "bench/growth_levels/pieces.hpp"
#include "runtime/level/json/limits.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace bench {

/// Parts that stay in place without support by others.
constexpr std::array<char const*, 10> placed{"crate",        "brick",     "block",       "plank",
                                             "steel ball",   "iron ball", "rubber ball", "wooden ball",
                                             "wooden wedge", "wooden bar"};

inline Json goals(int n) {
    Json made = lattice(n, 2, {{"shape", box(0.5, 0.5)}});
    Json all = Json::array();
    for (int i = 1; i < n; ++i) { // the condition "all" counts as one of the n
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

/// Changes of an accuracy setting during a run.
inline Json changes(int n) {
    Json made = twoBodies();
    Json all = Json::array();
    for (int i = 0; i < n; ++i) {
        all.push_back({{"frame", 1 + i}, {"setting", {{"solver", {{"substeps", 1 + i % 4}}}}}});
    }
    made["solutions"] = {{{"name", "changes"}, {"frames", n + framesOfGrowth}, {"changes", all}}};
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

/// Parts from the toolbox, each in a free place. Every part is used at most a thousand times.
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

/// The same, each in an area for placing of its own, a polygon.
inline Json placementsInAreas(int n) {
    Json made = placements(n);
    made["placing"] = Json::array();
    for (Json const& placement : made["solutions"][0]["placements"]) {
        double const x = placement["at"][0];
        double const y = placement["at"][1];
        made["placing"].push_back({{x - 1.4, y}, {x, y - 1.4}, {x + 1.4, y}, {x, y + 1.4}});
    }
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

} // namespace bench
