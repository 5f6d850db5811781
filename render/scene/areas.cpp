#include "render/scene/areas.hpp"

#include "render/scene/marks/dashes.hpp"
#include "render/scene/marks/hatch.hpp"

#include <numbers>

namespace trembler::render {
namespace {

void drawTint(Canvas& canvas, std::vector<Point> const& outline, Colour colour, float alpha) {
    canvas.polygon({}, outline, {.tint = colour, .outline = 0.F, .alpha = alpha, .height = 0.F});
}

} // namespace

std::vector<Point> outlineOf(Area const& area) {
    std::vector<Point> corners;
    if (area.box) {
        Point const from = toPoint(area.box->corner);
        Point const to = toPoint(area.box->corner + area.box->size);
        return {from, {to.x, from.y}, to, {from.x, to.y}};
    }
    for (Vec2 const corner : area.corners) {
        corners.push_back(toPoint(corner));
    }
    return corners;
}

Extent extentOf(Area const& area) {
    Extent around;
    for (Point const corner : outlineOf(area)) {
        around.add(corner);
    }
    return around;
}

void drawPlacingArea(Canvas& canvas, Area const& area, bool faint) {
    std::vector<Point> const outline = outlineOf(area);
    if (faint) {
        drawTint(canvas, outline, palette::accent, 0.025F);
        dashed(canvas, outline, true, canvas.metres(4), canvas.metres(7),
               {.colour = palette::accent, .pixels = 1.2F, .alpha = 0.38F});
        return;
    }
    drawTint(canvas, outline, palette::accent, 0.05F);
    hatch(canvas, outline, {}, 0.75 * std::numbers::pi, canvas.metres(13),
          {.colour = palette::accent, .pixels = 1.F, .alpha = 0.20F});
    dashed(canvas, outline, true, canvas.metres(5), canvas.metres(5),
           {.colour = palette::accent, .pixels = 1.6F, .alpha = 0.6F});
}

void drawGoalRegion(Canvas& canvas, GoalRegion const& goal) {
    std::vector<Point> const outline = outlineOf(goal.area);
    drawTint(canvas, outline, palette::goal, goal.met ? 0.16F : 0.06F);
    Stroke line{.colour = palette::goal, .pixels = goal.met ? 3.4F : 2.6F};
    if (goal.met) {
        line.glow = {palette::goal, canvas.metres(7), 0.35F};
    }
    dashed(canvas, outline, true, canvas.metres(14), canvas.metres(8), line);
}

} // namespace trembler::render
