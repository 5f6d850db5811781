// The conditions for valid shapes, checked for files and for objects created while a world runs.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

#include <optional>
#include <string>

namespace trembler {

inline constexpr double minimumExtent = 0.01; ///< m: the least thickness and length

/// The fault of the shape and the expected condition, in words; nothing if it is valid. Corners must run
/// anticlockwise: clockwise corners are refused, not reversed, as other effects rely on the order, too.
[[nodiscard]] std::optional<std::string> faultIn(Shape const& shape);

} // namespace trembler
