#include "render/scene/objects/winding.hpp"

#include "render/scene/marks/signs.hpp"
#include "render/scene/objects/compound.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::render {
namespace {

constexpr Colour flangeColour = rgb(0x4A4348);
constexpr Colour boltBrass = rgb(0xD8B25A);

/// That of a box's four directions which is nearest to `axis`: a wire is wound around the box's sides, even
/// if the pole lies at a corner.
Point alongBox(ShapePiece const& box, Point axis) {
    Point const own{std::cos(box.angle), std::sin(box.angle)};
    Point const across{-own.y, own.x};
    double const x = dot(axis, own);
    double const y = dot(axis, across);
    return std::abs(x) > std::abs(y) ? std::copysign(1.0, x) * own : std::copysign(1.0, y) * across;
}

Point axisOf(Facts const& facts, ShapePiece const& piece) {
    Point axis;
    if (facts.poles != nullptr) {
        Point const north = toPoint(facts.poles->north);
        Point const south = toPoint(facts.poles->south);
        Point const middle = centroidOf(*facts.shape);
        switch (facts.poles->poles) {
        case PoleSet::both:
            axis = north - south;
            break;
        case PoleSet::north:
            axis = north - middle;
            break;
        case PoleSet::south:
            axis = south - middle;
            break;
        case PoleSet::none:
            break;
        }
    }
    if (!(length(axis) > 1e-6)) {
        ShapePiece upright = piece;
        upright.angle = 0;
        Point const half = extentOf(upright, {}).half();
        double const turn = piece.angle + (half.x >= half.y ? 0 : 0.5 * pi);
        axis = {std::cos(turn), std::sin(turn)};
    }
    return piece.form == ShapeForm::box ? alongBox(piece, axis) : (1 / length(axis)) * axis;
}

} // namespace

Winding windingOf(Facts const& facts) {
    ShapePiece const& piece = largestPiece(*facts.shape);
    std::vector<Point> const outline = outlineOf(piece);
    Winding winding;
    winding.axis = axisOf(facts, piece);
    Point const across{-winding.axis.y, winding.axis.x};
    Point const middle = extentOf(piece, {}).centre();
    double first = 0;
    double last = 0;
    double side = 0;
    for (Point const corner : outline) {
        first = std::min(first, dot(corner - middle, winding.axis));
        last = std::max(last, dot(corner - middle, winding.axis));
        side = std::max(side, std::abs(dot(corner - middle, across)));
    }
    double const span = last - first;
    // The core extends beyond the winding far enough to fasten wires and to show the pole, also where it is
    // short.
    double const end = std::clamp(0.1, 0.16 * span, 0.22 * span);
    winding.from = middle + (first + end) * winding.axis;
    winding.to = middle + (last - end) * winding.axis;
    winding.halfWidth = side;
    Point const back = middle + (first + 0.5 * end) * winding.axis;
    winding.terminals = {back + 0.62 * side * across, back - 0.62 * side * across};
    return winding;
}

namespace {

// The face that pulls, in the colour of its pole and with its letter.
void drawFace(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style,
              Winding const& winding, std::span<Point const> outline, float level) {
    if (facts.poles == nullptr || facts.poles->poles == PoleSet::none || !(level > 0)) {
        return;
    }
    auto const face = [&](Sign sign, Point end, Point outwards) {
        Style paint = style;
        paint.pattern = Pattern::Plastic;
        paint.tint = sign == Sign::north ? palette::northPole : palette::southPole;
        paint.alpha = style.alpha * level;
        paint.height = 0;
        paint.selected = false;
        paint.glow = {};
        canvas.polygon(pose, clipHalf(outline, end, outwards), paint);
        double reach = 0; // from the winding to the core's end
        for (Point const corner : outline) {
            reach = std::max(reach, dot(corner - end, outwards));
        }
        Point const at = end + 0.58 * reach * outwards;
        drawSign(canvas, sign, {toWorld(pose, at), 0}, 0.45 * reach, palette::paperLight, level);
    };
    bool const north = facts.poles->poles != PoleSet::south;
    face(north ? Sign::north : Sign::south, winding.to, winding.axis);
    if (facts.poles->poles == PoleSet::both) {
        face(Sign::south, winding.from, -1.0 * winding.axis);
    }
}

} // namespace

void drawWinding(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style) {
    ShapePiece const& piece = largestPiece(*facts.shape);
    std::vector<Point> const outline = outlineOf(piece);
    Winding const winding = windingOf(facts);
    Point const across{-winding.axis.y, winding.axis.x};
    double const span = length(winding.to - winding.from);
    int const turns =
        std::clamp(static_cast<int>(std::lround(span / (0.16 * winding.halfWidth + 0.02))), 4, 14);
    double const pitch = span / turns;
    auto const level = static_cast<float>(std::clamp(facts.magnetLevel(), 0.0, 1.0));

    drawFace(canvas, facts, pose, style, winding, outline, level);

    Style wire = style;
    wire.pattern = Pattern::Copper;
    wire.tint = mix(palette::copper, palette::live, 0.55F * level);
    wire.outline = 1.2F;
    wire.height = 0.35F;
    wire.grain = 0.5 * pitch;
    wire.selected = false;
    wire.glow = {};
    for (int i = 0; i < turns; ++i) {
        Point const at = winding.from + (i + 0.5) * pitch * winding.axis;
        if (auto const chord = clipLine(outline, at, across)) {
            // Wires run slantwise around the core and protrude a little at its sides.
            Point const slant = 0.22 * pitch * winding.axis;
            double const radius = 0.5 * pitch;
            canvas.capsule(toWorld(pose, (*chord)[0] - slant), toWorld(pose, (*chord)[1] + slant), radius,
                           wire);
        }
    }
    Style flange = wire;
    flange.pattern = Pattern::Plastic;
    flange.tint = flangeColour;
    flange.outline = 1.4F;
    flange.grain = 0;
    double const thickness = std::max(0.035 * span, 0.3 * pitch);
    double const turn = pose.angle + std::atan2(winding.axis.y, winding.axis.x);
    for (Point const end : {winding.from, winding.to}) {
        double const width = 1.06 * winding.halfWidth + 0.5 * pitch;
        canvas.box({toWorld(pose, end), turn}, {thickness, width}, 0.5 * thickness, flange);
    }
    Style bolt = wire;
    bolt.tint = boltBrass;
    double const size = std::min(0.16 * winding.halfWidth, 0.05);
    for (Point const terminal : winding.terminals) {
        canvas.circle({toWorld(pose, terminal), pose.angle}, size, bolt);
    }
}

} // namespace trembler::render
