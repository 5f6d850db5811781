// Reads areas of the plane: a level's bounds, areas for placing, areas of goals.
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/model/level.hpp"

namespace trembler {

/// m, the greatest distance of a place from the origin along each axis, like Position.
inline constexpr double farthestPlace = 1e6;

/// [x, y, width, height] in m, (x, y) the lower left corner.
[[nodiscard]] std::optional<Box> readBox(JsonNode const& node);
/// A box, or a polygon [[x, y], ...] of at least three corners.
[[nodiscard]] std::optional<Area> readArea(JsonNode const& node);

} // namespace trembler
