// Levels with n fuses, generators or sound sensors.
#pragma once

#include "bench/growth_levels/pieces.hpp"

namespace bench {

/// Fuses side by side, all overloaded from the start.
inline Json fuses(int n) {
    Json made = level("fuses");
    add(made, "source", 0, 0, {{"conductor", true}, {"electrical_source", true}, {"emf", {{"voltage", 10}}}});
    add(made, "return", 2, 0, {{"conductor", true}, {"electrical_return", true}});
    for (int i = 0; i < n; ++i) {
        add(made, numbered("fuse", i), i, 5,
            {{"conductor", true}, {"resistance", 1}, {"fuse", {{"current", 0.5}}}});
        made["connections"].push_back({"source", numbered("fuse", i)});
        made["connections"].push_back({numbered("fuse", i), "return"});
    }
    return made;
}

/// Generators that turn, each with a source and a return of its own.
inline Json generators(int n) {
    Json made = level("generators");
    for (int i = 0; i < n; ++i) {
        add(made, numbered("source", i), 2 * i, 6, {{"conductor", true}, {"electrical_source", true}});
        add(made, numbered("return", i), 2 * i, 7, {{"conductor", true}, {"electrical_return", true}});
        add(made, numbered("rotor", i), 2 * i, 5,
            {{"shape", box(0.5, 0.1)},
             {"conductor", true},
             {"angular_velocity_deg", 360},
             {"generator", {{"source", numbered("source", i)}}}});
        made["joints"].push_back({{"form", "hinge"}, {"a", numbered("rotor", i)}, {"at", {2 * i, 5}}});
        made["connections"].push_back({numbered("rotor", i), numbered("return", i)});
    }
    return made;
}

/// Sound sensors, which hear one box that lands.
inline Json sensors(int n) {
    Json made = row(1, 0.5, 0.01);
    made["objects"].back()["properties"]["material"] = "steel";
    for (int i = 0; i < n; ++i) {
        add(made, numbered("sensor", i), i, 1,
            {{"shape", box(0.1, 0.1)}, {"fixed", true}, {"conductor", true}, {"sound_sensor", true}});
    }
    return made;
}

} // namespace bench
