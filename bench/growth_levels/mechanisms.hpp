// Levels with n pulleys, gears, or pieces of bodies.
#pragma once

#include "bench/growth_levels/pieces.hpp"

#include <algorithm>

namespace bench {

/// Bodies on sliders, rods, ropes or wheels of their own.
inline Json guided(int n, char const* form) {
    Json made = level(form);
    for (int i = 0; i < n; ++i) {
        add(made, numbered("peg", i), 2 * i, 1, {{"shape", box(0.1, 0.1)}, {"fixed", true}});
        add(made, numbered("bob", i), 2 * i, 0, {{"shape", box(0.5, 0.5)}});
        made["joints"].push_back({{"form", form},
                                  {"a", numbered("peg", i)},
                                  {"b", numbered("bob", i)},
                                  {"at", {2 * i, 1}},
                                  {"at_b", {2 * i, 0}},
                                  {"axis", {0, 1}},
                                  {"stiffness", 100}});
    }
    return made;
}

/// Pairs of bodies that hang from pulleys.
inline Json pulleys(int n) {
    Json made = level("pulleys");
    for (int i = 0; i < n; ++i) {
        double const x = 4 * i;
        add(made, numbered("left", i), x, 0, {{"shape", box(0.5, 0.5)}});
        add(made, numbered("right", i), x + 1, 0, {{"shape", box(0.5, 0.4)}});
        made["joints"].push_back({{"form", "pulley"},
                                  {"a", numbered("left", i)},
                                  {"b", numbered("right", i)},
                                  {"at", {x, 0}},
                                  {"at_b", {x + 1, 0}},
                                  {"ground_a", {x, 2}},
                                  {"ground_b", {x + 1, 2}}});
    }
    return made;
}

/// Wheels on axles in a row, each geared to the next one.
inline Json gears(int n) {
    Json made = level("gears");
    for (int i = 0; i < n; ++i) {
        add(made, numbered("wheel", i), 2 * i, 0, {{"shape", box(0.5, 0.5)}});
        made["joints"].push_back({{"name", numbered("axle", i)},
                                  {"form", "hinge"},
                                  {"a", numbered("wheel", i)},
                                  {"at", {2 * i, 0}}});
        if (i > 0) {
            made["joints"].push_back({{"form", "gear"},
                                      {"a", numbered("wheel", i - 1)},
                                      {"b", numbered("wheel", i)},
                                      {"joint_a", numbered("axle", i - 1)},
                                      {"joint_b", numbered("axle", i)},
                                      {"ratio", -1}});
        }
    }
    return made;
}

/// Bodies that fall, of up to a hundred pieces each.
inline Json piecesOfBodies(int n) {
    constexpr int ofOne = 100;
    Json made = level("pieces");
    for (int first = 0; first < n; first += ofOne) {
        Json shape = Json::array();
        for (int i = first; i < std::min(n, first + ofOne); ++i) {
            shape.push_back({{"form", "box"},
                             {"width", 0.1},
                             {"height", 0.1},
                             {"at", {0.1 * (i % 10), 0.1 * (i % ofOne / 10)}}});
        }
        add(made, numbered("body", first), 2.0 * first / ofOne, 0, {{"shape", shape}});
    }
    return made;
}

} // namespace bench
