// Pieces of which the levels of bench_growth are made.
#pragma once

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <utility>

namespace bench {

using Json = nlohmann::json;

/// Frames that are measured after the first one.
constexpr int framesOfGrowth = 5;

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

/// Objects on a square lattice, `apart` m from each other.
inline Json lattice(int n, double apart, Json const& properties) {
    Json made = level("lattice");
    int const side = static_cast<int>(std::ceil(std::sqrt(n)));
    for (int i = 0; i < n; ++i) {
        add(made, numbered("thing", i), apart * (i % side), apart * static_cast<double>(i / side),
            properties);
    }
    return made;
}

} // namespace bench
