// Places on the sheet: where parts may be placed, and the regions of goals.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/facts/shape_geometry.hpp"
#include "runtime/level/model/level.hpp"

#include <vector>

namespace trembler::render {

/// The area's corners in the world.
[[nodiscard]] std::vector<Point> outlineOf(Area const& area);
/// The smallest rectangle around it.
[[nodiscard]] Extent extentOf(Area const& area);

/// Parts may be placed here: softly hatched, or, if `faint`, as long as none is held, with a thin
/// outline only. Draw it under everything else.
void drawPlacingArea(Canvas& canvas, Area const& area, bool faint = false);

/// A region that a goal is about.
struct GoalRegion {
    Area area;
    bool met = false; ///< the goal is reached at present
};

/// A dashed outline over a faint tint.
void drawGoalRegion(Canvas& canvas, GoalRegion const& goal);

} // namespace trembler::render
