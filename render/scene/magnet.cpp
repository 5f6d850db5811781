#include "render/scene/magnet.hpp"

#include "render/scene/body.hpp"
#include "render/scene/shape_geometry.hpp"
#include "render/scene/signs.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::render {
namespace {

void paint(Canvas& canvas, Shape const& shape, Pose const& pose, Style style, Point at, Point normal) {
    for (ShapePiece const& piece : shape.pieces) {
        std::vector<Point> const half = clipHalf(outlineOf(piece), at, normal);
        if (half.size() >= 3) {
            canvas.polygon(pose, half, style);
        }
    }
}

bool has(PoleSet set, PoleSet which) {
    return set == which || set == PoleSet::both;
}

void drawPoleLetters(Canvas& canvas, Facts const& facts, Pose const& pose, Colour colour, float alpha) {
    Point const middle = centroidOf(*facts.shape);
    double const size = 0.62 * innerSize(facts);
    auto const letter = [&](Sign sign, Point pole) {
        // A pole that sits on the edge has its letter further in, and letters stay upright.
        Point const from = pole - middle;
        double const reach = length(from);
        double const inner = std::max(0.0, reach - 1.1 * size);
        Point const at = reach > 0 ? middle + (inner / reach) * from : middle;
        drawSign(canvas, sign, {toWorld(pose, at), 0}, size, colour, alpha);
    };
    if (has(facts.poles->poles, PoleSet::north)) {
        letter(Sign::north, toPoint(facts.poles->north));
    }
    if (has(facts.poles->poles, PoleSet::south)) {
        letter(Sign::south, toPoint(facts.poles->south));
    }
}

} // namespace

void drawMagnet(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style) {
    Point const north = toPoint(facts.poles->north);
    Point const south = toPoint(facts.poles->south);
    Style enamel = style;
    enamel.material = Material::Plastic;
    enamel.height = 0;
    enamel.glow = {};
    enamel.selected = false;
    Point const axis = north - south;
    if (facts.poles->poles == PoleSet::both && length(axis) > 0) {
        Point const middle = 0.5 * (north + south);
        enamel.tint = palette::northPole;
        paint(canvas, *facts.shape, pose, enamel, middle, axis);
        enamel.tint = palette::southPole;
        paint(canvas, *facts.shape, pose, enamel, middle, -1.0 * axis);
    } else {
        enamel.tint = facts.poles->poles == PoleSet::south ? palette::southPole : palette::northPole;
        drawShape(canvas, *facts.shape, pose, enamel);
    }
    drawPoleLetters(canvas, facts, pose, palette::paperLight, style.ghost ? 0.6F : 1.F);
}

} // namespace trembler::render
