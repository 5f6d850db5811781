#include "physics/dynamics/properties/shape.hpp"

#include "physics/dynamics/properties/shapes/shape_order.hpp"

namespace trembler {

ShapePiece circlePiece(double radius, Vec2 at) {
    ShapePiece piece;
    piece.form = ShapeForm::circle;
    piece.radius = radius;
    piece.at = at;
    return piece;
}

ShapePiece boxPiece(double width, double height, Vec2 at, double angle) {
    ShapePiece piece;
    piece.form = ShapeForm::box;
    piece.width = width;
    piece.height = height;
    piece.at = at;
    piece.angle = angle;
    return piece;
}

ShapePiece capsulePiece(double length, double radius, Vec2 at, double angle) {
    ShapePiece piece;
    piece.form = ShapeForm::capsule;
    piece.width = length;
    piece.radius = radius;
    piece.at = at;
    piece.angle = angle;
    return piece;
}

ShapePiece polygonPiece(std::vector<Vec2> corners, Vec2 at, double angle) {
    ShapePiece piece;
    piece.form = ShapeForm::polygon;
    piece.corners = std::move(corners);
    piece.at = at;
    piece.angle = angle;
    return piece;
}

double areaOf(ShapePiece const& piece) {
    switch (piece.form) {
    case ShapeForm::circle:
        return pi * piece.radius * piece.radius;
    case ShapeForm::box:
        return piece.width * piece.height;
    case ShapeForm::capsule:
        return (piece.width - 2 * piece.radius) * 2 * piece.radius + pi * piece.radius * piece.radius;
    case ShapeForm::polygon: {
        double twice = 0; // the shoelace formula
        for (std::size_t i = 0; i < piece.corners.size(); ++i) {
            twice += cross(piece.corners[i], piece.corners[(i + 1) % piece.corners.size()]);
        }
        return twice / 2;
    }
    }
    return 0;
}

namespace {

double sumOfAreas(std::vector<ShapePiece> const& pieces) {
    double area = 0;
    for (ShapePiece const& piece : pieces) {
        area += areaOf(piece);
    }
    return area;
}

} // namespace

double areaOf(Shape const& shape) {
    // A shape that is not finite has no order and is used unchanged.
    return isInOrder(shape) ? sumOfAreas(shape.pieces) : sumOfAreas(inOrder(shape).pieces);
}

} // namespace trembler
