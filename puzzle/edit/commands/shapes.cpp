#include "puzzle/edit/commands/shapes.hpp"

#include "physics/dynamics/properties/shape.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "puzzle/edit/tree/convex_pieces.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/property/property_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::edit {
namespace {

/// Throws CommandError for a shape that no file may state.
DrawnShape checkedShape(Vec2 at, double angleDegrees, Shape shape) {
    if (!isFinite(at) || !std::isfinite(angleDegrees)) {
        throw CommandError("the drawing is too large");
    }
    if (auto const fault = faultIn(shape)) {
        throw CommandError(fmt::format("this shape is not possible: {}", *fault));
    }
    return {at, angleDegrees, writeProperty(ValueOf<Shape>(std::move(shape)))};
}

/// To a nanometre, so that files have no rounding errors.
double neat(double metres) {
    return std::round(metres * 1e9) / 1e9;
}

Vec2 neat(Vec2 point) {
    return {neat(point.x), neat(point.y)};
}

} // namespace

DrawnShape drawnBox(Vec2 from, Vec2 to) {
    return checkedShape(neat((from + to) * 0.5), 0,
                        {{boxPiece(neat(std::abs(to.x - from.x)), neat(std::abs(to.y - from.y)))}});
}

DrawnShape drawnDisc(Vec2 centre, Vec2 edge) {
    return checkedShape(neat(centre), 0, {{circlePiece(neat(length(edge - centre)))}});
}

DrawnShape drawnCapsule(Vec2 from, Vec2 to, double radius) {
    Vec2 const way = to - from;
    double const degrees = std::round(std::atan2(way.y, way.x) * (180 / pi) * 1e6) / 1e6;
    return checkedShape(neat((from + to) * 0.5), degrees,
                        {{capsulePiece(neat(length(way) + 2 * radius), neat(radius))}});
}

DrawnShape drawnPolygon(std::span<Vec2 const> corners) {
    ConvexPieces const pieces = convexPieces(corners);
    Vec2 const centre = neat(pieces.centre);
    Shape shape;
    for (std::vector<Vec2> const& piece : pieces.pieces) {
        std::vector<Vec2> around;
        for (Vec2 const corner : piece) {
            around.push_back(neat(corner - centre));
        }
        shape.pieces.push_back(polygonPiece(std::move(around)));
    }
    return checkedShape(centre, 0, std::move(shape));
}

} // namespace trembler::edit
