// Levels of many boxes, as the text of their files.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace trembler::test {

/// A level of `count` boxes of 10 cm whose middles are `apart` m apart in a row: in one place if it is 0.
inline std::string levelOfBoxes(int count, double apart) {
    using nlohmann::json;
    json objects = json::array();
    for (int i = 0; i < count; ++i) {
        json const shape = {{"form", "box"}, {"width", 0.1}, {"height", 0.1}};
        objects.push_back({{"name", "box " + std::to_string(i)},
                           {"at", {apart * i, 1}},
                           {"properties", {{"shape", json::array({shape})}}}});
    }
    json const all = {{"version", 2},
                      {"title", "boxes"},
                      {"world", {{"gravity", {0, -10}}, {"bounds", {-1, -1, 100, 10}}}},
                      {"objects", objects}};
    return all.dump();
}

} // namespace trembler::test
