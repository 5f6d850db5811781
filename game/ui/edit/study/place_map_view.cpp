#include "game/ui/edit/study/place_map_view.hpp"

#include "game/ui/edit/study/level_studies.hpp"
#include "render/draw/palette.hpp"
#include "render/scene/objects/body.hpp"

namespace trembler::ui {
namespace {

using namespace render;

/// A square where the part solves the level, a cross where it does not: distinguished by more than colour.
void drawPlace(Canvas& canvas, Point at, double step, char state) {
    double const half = 0.42 * step;
    if (state == '#') {
        canvas.box({at, 0}, {half, half}, 0.2 * half,
                   {.tint = palette::goal, .outline = 1, .alpha = 0.6F, .height = 0, .flat = true});
    } else if (state == '.') {
        double const arm = 0.5 * half;
        Stroke const stroke{.colour = palette::warning, .pixels = 2, .alpha = 0.85F};
        canvas.line(at + Point{-arm, -arm}, at + Point{arm, arm}, stroke);
        canvas.line(at + Point{-arm, arm}, at + Point{arm, -arm}, stroke);
    }
}

void drawCells(Canvas& canvas, insight::PlaceMap const& map, Vec2 middle) {
    for (std::size_t row = 0; row < map.rows.size(); ++row) {
        for (std::size_t column = 0; column < map.rows[row].size(); ++column) {
            double const x = map.step * (static_cast<double>(column) - static_cast<double>(map.column));
            double const y = map.step * (static_cast<double>(map.row) - static_cast<double>(row));
            drawPlace(canvas, {middle.x + x, middle.y + y}, map.step, map.rows[row][column]);
        }
    }
    canvas.ring({middle.x, middle.y}, 0.5 * map.step,
                {.colour = palette::ink, .pixels = 2, .alpha = 0.9F}); // where it was recorded
}

} // namespace

void drawPlaceMap(EditParts& parts, Canvas& canvas) {
    LevelStudies const& studies = *parts.studies;
    auto const report = studies.report().result();
    if (parts.tab != Tab::report || report == nullptr || studies.solution >= report->solutions.size()) {
        return;
    }
    insight::SolutionReport const& solution = report->solutions[studies.solution];
    Solution const* const recorded = studies.report().of->level.findSolution(solution.name);
    if (recorded == nullptr) {
        return;
    }
    canvas.newSheet();
    for (Placement const& placement : recorded->placements) {
        Prototype const* const part = parts.catalog().prototype(placement.part);
        if (part != nullptr && !placement.flipped) { // prototypes are not mirrored
            drawGhost(canvas, *part, {{placement.at.x, placement.at.y}, placement.angle}, true);
        }
    }
    if (studies.placement < solution.maps.size()) {
        insight::PlaceMap const& map = solution.maps[studies.placement];
        if (map.placement < recorded->placements.size()) {
            canvas.newSheet();
            drawCells(canvas, map, recorded->placements[map.placement].at);
        }
    }
}

} // namespace trembler::ui
