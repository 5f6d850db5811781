#include "runtime/level/read/read_area.hpp"

#include "runtime/level/json/limits.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

constexpr double smallest = 1e-3; // m: a narrower shape is not an area

/// Whether all corners lie within half the smallest width of one line.
bool isFlat(std::vector<Vec2> const& corners) {
    Vec2 const from = corners.front();
    Vec2 const to = *std::max_element(corners.begin(), corners.end(), [&](Vec2 a, Vec2 b) {
        return lengthSquared(a - from) < lengthSquared(b - from);
    });
    double const length = std::sqrt(lengthSquared(to - from));
    return std::all_of(corners.begin(), corners.end(), [&](Vec2 corner) {
        return length < smallest || std::abs(cross(to - from, corner - from)) / length < smallest / 2;
    });
}

} // namespace

std::optional<Box> readBox(JsonNode const& node) {
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
    if (node.value().is_array() && !node.isList("an area", limits::areaCorners)) {
        return std::nullopt;
    }
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
    if (good && isFlat(area.corners)) {
        node.complain("is flat: no point is inside", "corners that do not lie on one line");
        return std::nullopt;
    }
    return good ? std::optional(area) : std::nullopt;
}

} // namespace trembler
