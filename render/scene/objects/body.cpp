#include "render/scene/objects/body.hpp"

#include "render/scene/facts/look_form.hpp"
#include "render/scene/facts/poses.hpp"
#include "render/scene/facts/shape_geometry.hpp"
#include "render/scene/marks/brick.hpp"
#include "render/scene/marks/hatch.hpp"
#include "render/scene/objects/compound.hpp"
#include "render/scene/objects/device.hpp"
#include "render/scene/objects/drawing.hpp"

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
        // Grain runs along the longer side.
        bool const upright = half.y > half.x;
        canvas.box(upright ? Pose{pose.at, pose.angle + 0.5 * pi} : pose,
                   upright ? Point{half.y, half.x} : half, corner, style);
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

// Pieces that only just meet have their rims between them: paints them over.
void hideSeams(Canvas& canvas, Shape const& shape, Pose const& pose, Style const& style) {
    double const rim = canvas.metres(static_cast<double>(style.outline));
    Colour const colour = style.tint.value_or(colourOf(style.pattern));
    Stroke const patch{.colour = style.hovered ? mix(colour, rgb(0xFFFFFF), 0.16F) : colour,
                       .width = 1.1 * rim};
    for (Segment const& seam : edgesOf(shape, rim).seams) {
        Point const along = seam[1] - seam[0];
        double const span = length(along);
        double const end = 1.55 * rim; // the body's own rim stays
        if (span > 2 * end) {
            Point const unit = (1 / span) * along;
            Point const across{-unit.y, unit.x};
            for (double const side : {-0.7, 0.0, 0.7}) {
                Point const shift = (side * rim) * across;
                canvas.line(toWorld(pose, seam[0] + end * unit + shift),
                            toWorld(pose, seam[1] - end * unit + shift), patch);
            }
        }
    }
}

// A translucent surface must not be drawn twice where pieces overlap, nor show their rims inside.
void drawTranslucent(Canvas& canvas, Shape const& shape, Pose const& pose, Style style) {
    double const pixels = static_cast<double>(style.outline);
    Colour const tint = style.tint.value_or(colourOf(style.pattern));
    style.outline = 0;
    for (std::vector<Point> const& part : withoutOverlaps(shape)) {
        canvas.polygon(pose, part, style);
    }
    Stroke const rim{.colour = style.forbidden
                                   ? palette::warning
                                   : mix(palette::ink, {tint.red, tint.green, tint.blue, 255}, 0.3F),
                     .pixels = static_cast<float>(pixels),
                     .alpha = style.ghost && !style.forbidden ? 0.7F : 1.F};
    for (Segment const& edge : edgesOf(shape, 0).outer) {
        canvas.line(toWorld(pose, edge[0]), toWorld(pose, edge[1]), rim);
    }
}

} // namespace

void drawShape(Canvas& canvas, Shape const& shape, Pose const& pose, Style style) {
    if (!(style.grain > 0)) {
        // One pattern for all pieces, and not a coarse one on large shapes.
        Point const half = extentOf(shape, {}).half();
        style.grain = std::clamp(std::min(half.x, half.y), 0.02, 0.22);
    }
    if (shape.pieces.size() == 1 || style.layer == Layer::Shadow) {
        for (ShapePiece const& piece : shape.pieces) {
            drawPiece(canvas, piece, pose, shape.pieces.size() == 1, style);
        }
        return;
    }
    Colour const tint = style.tint.value_or(colourOf(style.pattern));
    if (style.ghost || style.alpha < 1.F || tint.alpha < 255) {
        drawTranslucent(canvas, shape, pose, style);
        return;
    }
    for (Layer const layer : {Layer::Rim, Layer::Inside}) {
        style.layer = layer;
        for (ShapePiece const& piece : shape.pieces) {
            drawPiece(canvas, piece, pose, false, style);
        }
    }
    hideSeams(canvas, shape, pose, style);
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
        // A translucent material stays translucent in any colour.
        Colour const usual = style.tint.value_or(colourOf(style.pattern));
        style.tint = Colour{own->red, own->green, own->blue, usual.alpha};
    }
    return style;
}

namespace {

// The body, and the marks that follow from the object's properties.
void drawByProperties(Canvas& canvas, Facts const& facts, Pose const& pose, Style style) {
    if (facts.shape != nullptr) {
        style.glow = deviceGlow(facts);
        bool const bulb = formOf(facts) == LookForm::bulb;
        if (bulb) {
            drawBulb(canvas, facts, pose, style);
        } else {
            drawShape(canvas, *facts.shape, pose, style);
        }
        float const strength = style.ghost ? 0.4F : 1.F;
        if (facts.substance == Substance::brick) {
            drawMortar(canvas, *facts.shape, pose, strength);
        } else if (facts.fixed && !facts.liquid && !isMetal(facts.substance) && !facts.device && !bulb) {
            hatchShape(canvas, *facts.shape, pose, strength);
        }
    }
    drawDevice(canvas, facts, pose, style);
}

} // namespace

void drawObject(Canvas& canvas, Facts const& facts, Pose const& pose, Marks const& marks) {
    Style style = styleOf(facts);
    style.selected = marks.selected;
    style.hovered = marks.hovered;
    style.ghost = marks.ghost || marks.forbidden;
    style.forbidden = marks.forbidden;
    if (facts.drawing == nullptr) {
        drawByProperties(canvas, facts, pose, style);
        return;
    }
    if (facts.drawing->marks) {
        drawByProperties(canvas, facts, pose, style);
    } else if (facts.shape != nullptr && !facts.shape->pieces.empty()) {
        Style body = style;
        body.glow = deviceGlow(facts);
        if (!facts.drawing->body) {
            body.layer = Layer::Shadow;
            body.tint = palette::ink; // glass may be drawn as anything
            body.glow = {};
        }
        drawShape(canvas, *facts.shape, pose, body);
    }
    drawShapes(canvas, facts, pose, style);
}

void drawGhost(Canvas& canvas, Prototype const& part, Pose const& pose, bool allowed) {
    drawObject(canvas, factsOf(part), pose, {.ghost = true, .forbidden = !allowed});
}

} // namespace trembler::render
