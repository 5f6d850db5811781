#include "runtime/level/read_area.hpp"

namespace trembler {
std::optional<Box> readBox(JsonNode const& node) {
    constexpr double smallest = 1e-3;
    if (!node.value().is_array() || node.size() != 4) {
        node.complainOfType(
            "a list [x, y, width, height] of four numbers, in m, (x, y) the lower left corner");
        return std::nullopt;
    }
    auto const x = node.element(0).number(-farthestPlace, farthestPlace);
    auto const y = node.element(1).number(-farthestPlace, farthestPlace);
    auto const width = node.element(2).number(smallest, 2 * farthestPlace);
    auto const height = node.element(3).number(smallest, 2 * farthestPlace);
    return x && y && width && height ? std::optional(Box{{*x, *y}, {*width, *height}}) : std::nullopt;
}

std::optional<Area> readArea(JsonNode const& node) {
    bool const isList = node.value().is_array() && node.size() >= 3;
    bool const isPolygon = isList && node.value()[0].is_array();
    if (!isList || (!isPolygon && node.size() != 4)) {
        node.complainOfType("a box [x, y, width, height] or a polygon [[x, y], [x, y], [x, y], ...], in m");
        return std::nullopt;
    }
    Area area;
    if (!isPolygon) {
        area.box = readBox(node);
        return area.box ? std::optional(area) : std::nullopt;
    }
    bool good = true;
    for (std::size_t i = 0; i < node.size(); ++i) {
        auto const corner = node.element(i).vector(-farthestPlace, farthestPlace);
        good = good && corner;
        area.corners.push_back(corner.value_or(Vec2{}));
    }
    return good ? std::optional(area) : std::nullopt;
}

} // namespace trembler
