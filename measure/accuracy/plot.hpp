// Draws error over time per frame as a picture.
#pragma once

#include "measure/accuracy/ladder.hpp"

namespace trembler::accuracy {

/// An SVG with two logarithmic axes; the Pareto front is drawn as a line through its filled dots. Exact
/// levels are drawn on the line "exact" at the bottom; levels of unbounded error at the top.
[[nodiscard]] std::string asSvg(Ladder const& ladder);

} // namespace trembler::accuracy
