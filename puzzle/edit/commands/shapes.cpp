#include "puzzle/edit/commands/shapes.hpp"

#include "physics/dynamics/properties/shape.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/tree/convex_pieces.hpp"
#include "puzzle/edit/tree/entry_pieces.hpp"
#include "puzzle/edit/tree/object_values.hpp"
#include "puzzle/edit/tree/polygon_outline.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/property/field_outline.hpp"
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

/// The polygons with these corners, in the frame in which the corners are stated.
Shape polygons(std::vector<std::vector<Vec2>> const& pieces, Vec2 centre) {
    Shape shape;
    for (std::vector<Vec2> const& piece : pieces) {
        std::vector<Vec2> around;
        for (Vec2 const corner : piece) {
            around.push_back(neat(corner - centre));
        }
        shape.pieces.push_back(polygonPiece(std::move(around)));
    }
    return shape;
}

/// The outline in the object's own frame; empty if it cannot be changed by its corners.
std::vector<Vec2> ownOutline(GameData const& data, Json const& entry) {
    if (isComposite(data, entry) || entry.contains("flipped")) {
        return {};
    }
    auto const shape = shapeOf(data, entry);
    return shape && !faultIn(*shape) ? polygonOutline(*shape).value_or(std::vector<Vec2>())
                                     : std::vector<Vec2>();
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
    return checkedShape(centre, 0, polygons(pieces.pieces, centre));
}

std::vector<Vec2> outlineCorners(GameData const& data, Json const& level, std::string const& name) {
    Json const* const entry = findObject(level, name);
    std::vector<Vec2> corners = entry == nullptr ? std::vector<Vec2>() : ownOutline(data, *entry);
    for (Vec2& corner : corners) {
        corner = placeOf(*entry) + rotated(corner, radians(angleOf(*entry)));
    }
    return corners;
}

Command moveCorner(GameData const& data, Json const& level, std::string const& name, std::size_t corner,
                   Vec2 to) {
    Json const* const entry = findObject(level, name);
    std::vector<Vec2> corners = entry == nullptr ? std::vector<Vec2>() : ownOutline(data, *entry);
    if (corner >= corners.size()) {
        throw CommandError(fmt::format("'{}' has no such corner", name));
    }
    if (isLocked(level, name)) {
        throw CommandError("the object is locked");
    }
    corners[corner] = rotated(to - placeOf(*entry), -radians(angleOf(*entry)));
    Json const shape = checkedShape(placeOf(*entry), 0, polygons(convexPieces(corners).pieces, {})).shape;
    return {
        fmt::format("Change shape of {}", name),
        [name, shape](Json& tree) { setStatement(objectEntry(tree, name), propertyInfo<Shape>(), shape); },
        {name}};
}

} // namespace trembler::edit
