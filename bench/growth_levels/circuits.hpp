// Levels with n connections, conductors or motors.
#pragma once

#include "bench/growth_levels/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace bench {

inline Json repeatedConnections(int n) {
    Json made = cable(1);
    for (int i = 0; i < n; ++i) {
        made["connections"].push_back({"source", "wire 0"});
    }
    return made;
}

inline Json refusedConnections(int n) {
    Json made = cable(n);
    for (Json& connection : made["connections"]) {
        connection[1] = "nothing " + connection[1].get<std::string>();
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

/// n networks, each with a source, a return and a lamp of its own, which share the way from their lamps to
/// their returns: one wire, or n wires in a row, of which each network uses a different one. A lamp of the
/// first networks is cut off in each frame.
inline Json networks(int n, bool row) {
    Json made = level("networks");
    add(made, "shared 0", 0, 0, {{"conductor", true}});
    Json inputs = Json::array();
    for (int i = 0; i < n; ++i) {
        std::string const network = numbered("network", i);
        std::string const shared = numbered("shared", row ? i : 0);
        add(made, numbered("source", i), i, 1,
            {{"conductor", true}, {"electrical_source", {{"network", network}}}});
        add(made, numbered("lamp", i), i, 2,
            {{"conductor", {{"network", network}}}, {"electrical_device", true}});
        add(made, numbered("return", i), i, 3,
            {{"conductor", true}, {"electrical_return", {{"network", network}}}});
        if (row && i > 0) {
            add(made, shared, i, 0, {{"conductor", true}});
            made["connections"].push_back({numbered("shared", i - 1), shared});
        }
        made["connections"].push_back({numbered("source", i), numbered("lamp", i)});
        made["connections"].push_back({numbered("lamp", i), shared});
        made["connections"].push_back({shared, numbered("return", i)});
    }
    for (int frame = 1; frame <= framesOfGrowth + 1; ++frame) {
        inputs.push_back({{"frame", frame}, {"cut", {numbered("source", frame), numbered("lamp", frame)}}});
    }
    made["solutions"] = {{{"name", "cut"}, {"inputs", inputs}}};
    return made;
}

/// n networks of three objects of their own, a source, a resistor and a return, which share one wire between
/// the resistors and the returns, at a detail level of electricity.
inline Json ownNetworks(int n, char const* detail) {
    Json made = level("own networks");
    add(made, "shared", 0, 0, {{"conductor", true}});
    for (int i = 0; i < n; ++i) {
        std::string const network = numbered("network", i);
        Json const own{{"network", network}};
        add(made, numbered("source", i), i, 1,
            {{"conductor", own}, {"electrical_source", own}, {"emf", {{"voltage", 10}}}});
        add(made, numbered("resistor", i), i, 2,
            {{"conductor", own}, {"resistance", 100}, {"current_capacity", 1}});
        add(made, numbered("return", i), i, 3, {{"conductor", own}, {"electrical_return", own}});
        made["connections"].push_back({numbered("source", i), numbered("resistor", i)});
        made["connections"].push_back({numbered("resistor", i), "shared"});
        made["connections"].push_back({"shared", numbered("return", i)});
    }
    made["world"]["detail"] = {{"electricity", detail}};
    Json inputs = Json::array();
    for (int frame = 1; frame <= framesOfGrowth + 1; ++frame) {
        inputs.push_back(
            {{"frame", frame}, {"cut", {numbered("source", frame), numbered("resistor", frame)}}});
    }
    made["solutions"] = {{{"name", "cut"}, {"inputs", inputs}}};
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

/// Running motors, all on one source.
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

} // namespace bench
