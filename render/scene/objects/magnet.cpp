#include "render/scene/objects/magnet.hpp"

#include "render/scene/facts/shape_geometry.hpp"
#include "render/scene/marks/signs.hpp"
#include "render/scene/objects/body.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::render {
namespace {

// The shape's pieces on one side of a line, as pieces.
Shape halfOf(Shape const& shape, Point at, Point normal) {
    Shape half;
    for (ShapePiece const& piece : shape.pieces) {
        ShapePiece part;
        part.form = ShapeForm::polygon;
        for (Point const corner : clipHalf(outlineOf(piece), at, normal)) {
            part.corners.push_back({corner.x, corner.y});
        }
        if (part.corners.size() >= 3) {
            half.pieces.push_back(std::move(part));
        }
    }
    return half;
}

bool has(PoleSet set, PoleSet which) {
    return set == which || set == PoleSet::both;
}

void drawPoleLetters(Canvas& canvas, Facts const& facts, Pose const& pose, Colour colour, float alpha) {
    auto const letter = [&](Sign sign, Point pole) {
        // In the piece that has the pole; not on its very edge. Letters stay upright.
        ShapePiece const& piece = *std::min_element(facts.shape->pieces.begin(), facts.shape->pieces.end(),
                                                    [&](ShapePiece const& a, ShapePiece const& b) {
                                                        return distanceTo(a, pole) < distanceTo(b, pole);
                                                    });
        Extent const own = extentOf(piece, {});
        double const size = 0.62 * std::min(own.half().x, own.half().y);
        Point const from = pole - own.centre();
        double const reach = length(from);
        double const inner = std::max(0.0, reach - 1.1 * size);
        Point const at = reach > 0 ? own.centre() + (inner / reach) * from : own.centre();
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
    enamel.pattern = Pattern::Plastic;
    enamel.height = 0;
    enamel.glow = {};
    enamel.selected = false;
    Point const axis = north - south;
    if (facts.poles->poles == PoleSet::both && length(axis) > 0) {
        Point const middle = 0.5 * (north + south);
        enamel.tint = palette::northPole;
        drawShape(canvas, halfOf(*facts.shape, middle, axis), pose, enamel);
        enamel.tint = palette::southPole;
        drawShape(canvas, halfOf(*facts.shape, middle, -1.0 * axis), pose, enamel);
    } else {
        enamel.tint = facts.poles->poles == PoleSet::south ? palette::southPole : palette::northPole;
        drawShape(canvas, *facts.shape, pose, enamel);
    }
    drawPoleLetters(canvas, facts, pose, palette::paperLight, style.ghost ? 0.6F : 1.F);
}

} // namespace trembler::render
