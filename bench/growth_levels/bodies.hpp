// Levels with n bodies, joints, pools or ears.
#pragma once

#include "bench/growth_levels/pieces.hpp"

namespace bench {

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

/// Bodies that each hang from a fixed body by a joint of their own.
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

/// Stacks of ten boxes.
inline Json stacks(int n) {
    Json made = level("stacks");
    addFloor(made, n * 0.1 + 20);
    for (int i = 0; i < n; ++i) {
        add(made, numbered("box", i), i / 10, 0.25 + 0.5 * (i % 10), {{"shape", box(0.5, 0.5)}});
    }
    return made;
}

/// Bodies in one place, each overlapping all others.
inline Json crowd(int n) {
    Json made = level("crowd");
    for (int i = 0; i < n; ++i) {
        add(made, numbered("box", i), 0, 0, {{"shape", box(0.5, 0.5)}});
    }
    return made;
}

inline Json masses(int n) {
    Json made = lattice(n, 20, {{"shape", box(1, 1)}, {"density", 1e5}});
    made["world"] = {{"gravity_law", true}};
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

inline Json overlappingPools(int n) {
    Json made = level("pools");
    for (int i = 0; i < n; ++i) {
        add(made, numbered("pool", i), 0, 0, {{"shape", box(1, 1)}, {"liquid", true}, {"density", 1000}});
    }
    return made;
}

/// Steel boxes that land in one frame, with listeners.
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

} // namespace bench
