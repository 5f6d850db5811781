#include "physics/dynamics/properties/shapes/mass_properties.hpp"

#include "physics/depth.hpp"
#include "physics/dynamics/properties/shapes/shape_order.hpp"

#include <algorithm>

namespace trembler {
namespace {

// Area, centroid and moment about the centroid per area, in the piece's frame.
MassProperties ofPolygon(std::vector<Vec2> const& corners) {
    // Fan of triangles from the first corner; the moment is first taken about that corner (Steiner).
    Vec2 const origin = corners.front();
    MassProperties sum;
    double moment = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        Vec2 const p = corners[i] - origin;
        Vec2 const q = corners[i + 1] - origin;
        double const area = cross(p, q) / 2;
        sum.area += area;
        sum.centre += area / 3 * (p + q);
        moment += area / 6 * (dot(p, p) + dot(p, q) + dot(q, q));
    }
    sum.centre *= 1 / sum.area;
    sum.inertiaPerMass = moment / sum.area - lengthSquared(sum.centre);
    sum.centre += origin;
    return sum;
}

MassProperties ofCapsule(double width, double radius) {
    double const half = width / 2 - radius; // from the centre to the middle of a round end
    double const box = 4 * half * radius;
    double const disc = pi * radius * radius;
    double const offset = 4 * radius / (3 * pi);
    double const boxMoment = box * (half * half + radius * radius) / 3;
    double const discMoment =
        disc * (radius * radius / 2 - offset * offset + (half + offset) * (half + offset));
    return {box + disc, {}, (boxMoment + discMoment) / (box + disc)};
}

MassProperties inOwnFrame(ShapePiece const& piece) {
    switch (piece.form) {
    case ShapeForm::circle:
        return {areaOf(piece), {}, piece.radius * piece.radius / 2};
    case ShapeForm::box:
        return {areaOf(piece), {}, (piece.width * piece.width + piece.height * piece.height) / 12};
    case ShapeForm::capsule:
        return ofCapsule(piece.width, piece.radius);
    case ShapeForm::polygon:
        return ofPolygon(piece.corners);
    }
    return {};
}

MassProperties ofPieces(Shape const& shape) {
    if (shape.pieces.size() == 1 && shape.pieces[0].at == Vec2{} && shape.pieces[0].angle == 0) {
        return inOwnFrame(shape.pieces[0]); // so that a centred piece is centred exactly
    }
    MassProperties all;
    for (ShapePiece const& piece : shape.pieces) {
        MassProperties const own = inOwnFrame(piece);
        all.area += own.area;
        all.centre += own.area * (piece.at + rotated(own.centre, piece.angle));
    }
    all.centre *= 1 / all.area;
    for (ShapePiece const& piece : shape.pieces) {
        MassProperties const own = inOwnFrame(piece);
        Vec2 const away = piece.at + rotated(own.centre, piece.angle) - all.centre;
        all.inertiaPerMass += own.area / all.area * (own.inertiaPerMass + lengthSquared(away));
    }
    return all;
}

} // namespace

MassProperties massPropertiesOf(Shape const& shape) {
    // A shape that is not finite has no order and is used unchanged.
    return isInOrder(shape) ? ofPieces(shape) : ofPieces(inOrder(shape));
}

Vec2 centreOfMass(Shape const& shape) {
    return massPropertiesOf(shape).centre;
}

double massFromDensity(Shape const& shape, Density const* density) {
    double const value = (density == nullptr ? Density{} : *density).value;
    return std::clamp(value * areaOf(shape) * worldDepth, 1e-6, 1e9);
}

double densityOf(Shape const& shape, Mass const* mass, Density const* density) {
    if (mass == nullptr || mass->value == massFromDensity(shape, density)) {
        return (density == nullptr ? Density{} : *density).value;
    }
    return mass->value / (areaOf(shape) * worldDepth);
}

} // namespace trembler
