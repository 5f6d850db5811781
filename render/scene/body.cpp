#include "render/scene/body.hpp"

#include "render/scene/device.hpp"
#include "render/scene/hatch.hpp"
#include "render/scene/poses.hpp"
#include "render/scene/shape_geometry.hpp"

#include <algorithm>

namespace trembler::render {
namespace {

void drawPiece(Canvas& canvas, ShapePiece const& piece, Pose const& body, bool alone, Style const& style) {
    Pose const pose{toWorld(body, toPoint(piece.at)), body.angle + piece.angle};
    switch (piece.form) {
    case ShapeForm::circle:
        canvas.circle(pose, piece.radius, style);
        break;
    case ShapeForm::box: {
        Point const half{0.5 * piece.width, 0.5 * piece.height};
        // Rounded corners would be notches where pieces meet.
        double const corner = alone ? std::min(0.12 * std::min(half.x, half.y), 0.02) : 0;
        canvas.box(pose, half, corner, style);
        break;
    }
    case ShapeForm::capsule: {
        double const along = std::max(0.0, 0.5 * piece.width - piece.radius);
        canvas.capsule(toWorld(pose, {-along, 0}), toWorld(pose, {along, 0}), piece.radius, style);
        break;
    }
    case ShapeForm::polygon: {
        std::vector<Point> corners;
        for (Vec2 const corner : piece.corners) {
            corners.push_back(toPoint(corner));
        }
        canvas.polygon(pose, corners, style);
        break;
    }
    }
}

} // namespace

void drawShape(Canvas& canvas, Shape const& shape, Pose const& pose, Style style) {
    if (!(style.grain > 0)) {
        // One pattern for all pieces, and not a coarse one on what is large.
        Point const half = extentOf(shape, {}).half();
        style.grain = std::clamp(std::min(half.x, half.y), 0.02, 0.22);
    }
    if (shape.pieces.size() == 1) {
        drawPiece(canvas, shape.pieces.front(), pose, true, style);
        return;
    }
    for (Layer const layer : {Layer::Rim, Layer::Inside}) {
        style.layer = layer;
        for (ShapePiece const& piece : shape.pieces) {
            drawPiece(canvas, piece, pose, false, style);
        }
    }
}

double innerSize(Facts const& facts) {
    if (facts.shape == nullptr) {
        return symbolRadius;
    }
    Point const half = extentOf(*facts.shape, {}).half();
    return std::min(half.x, half.y);
}

Style styleOf(Facts const& facts) {
    Style style = styleOf(facts.substance);
    if (std::optional<Colour> const own = colourFrom(facts.look != nullptr ? facts.look->colour : "")) {
        // What one sees through stays that way in any colour.
        Colour const usual = style.tint.value_or(colourOf(style.material));
        style.tint = Colour{own->red, own->green, own->blue, usual.alpha};
    }
    return style;
}

void drawObject(Canvas& canvas, Facts const& facts, Pose const& pose, Marks const& marks) {
    Style style = styleOf(facts);
    style.selected = marks.selected;
    style.hovered = marks.hovered;
    style.ghost = marks.ghost || marks.forbidden;
    style.forbidden = marks.forbidden;
    if (facts.shape != nullptr) {
        style.glow = deviceGlow(facts);
        drawShape(canvas, *facts.shape, pose, style);
        if (facts.fixed && !isMetal(facts.substance) && facts.coil == nullptr) {
            hatchShape(canvas, *facts.shape, pose, style.ghost ? 0.4F : 1.F);
        }
    }
    drawDevice(canvas, facts, pose, style);
}

void drawGhost(Canvas& canvas, Prototype const& part, Pose const& pose, bool allowed) {
    drawObject(canvas, factsOf(part), pose, {.ghost = true, .forbidden = !allowed});
}

} // namespace trembler::render
