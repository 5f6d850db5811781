// Which shapes are sound. Files are checked with it, and so is whatever comes into being while a world runs.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

#include <optional>
#include <string>

namespace trembler {

inline constexpr std::size_t maximumPieces = 256;
inline constexpr std::size_t maximumCorners = 8;
inline constexpr double minimumExtent = 0.01; ///< m: nothing is thinner or shorter

/// The fault of the shape and what was expected, in words; nothing if it is sound. Corners must run
/// anticlockwise: clockwise ones are refused, not turned round, as other effects rely on the order too.
[[nodiscard]] std::optional<std::string> faultIn(Shape const& shape);

} // namespace trembler
