// Error over time per frame, as a picture.
#pragma once

#include "measure/accuracy/ladder.hpp"

namespace trembler::accuracy {

/// An SVG with both axes logarithmic; the Pareto front is drawn as a line through its filled dots. What has
/// no error at all stands on the line at the bottom, "exact"; what has no bound, at the top.
[[nodiscard]] std::string asSvg(Ladder const& ladder);

} // namespace trembler::accuracy
