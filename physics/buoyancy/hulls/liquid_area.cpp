#include "physics/buoyancy/hulls/liquid_area.hpp"

#include "physics/dynamics/properties/shapes/corners.hpp"

namespace trembler {
namespace {

// The radius of a regular polygon that has the area of the unit circle.
double equalAreaRadius() {
    double const step = 2 * pi / static_cast<double>(roundSides);
    return std::sqrt(step / std::sin(step));
}

void addArc(std::vector<Vec2>& corners, Vec2 centre, double radius, double from, std::size_t steps) {
    double const step = 2 * pi / static_cast<double>(roundSides);
    for (std::size_t i = 0; i <= steps; ++i) {
        double const angle = from + step * static_cast<double>(i);
        corners.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
}

} // namespace

std::vector<Vec2> straightened(ShapePiece const& piece) {
    std::vector<Vec2> corners;
    switch (piece.form) {
    case ShapeForm::circle:
        addArc(corners, {}, piece.radius * equalAreaRadius(), 0, roundSides - 1);
        break;
    case ShapeForm::box:
    case ShapeForm::polygon:
        corners = straightCornersOf(piece);
        break;
    case ShapeForm::capsule: {
        double const half = piece.width / 2 - piece.radius;
        double const radius = piece.radius * equalAreaRadius();
        if (half > 0) {
            addArc(corners, {half, 0}, radius, -pi / 2, roundSides / 2);
            addArc(corners, {-half, 0}, radius, pi / 2, roundSides / 2);
        } else {
            addArc(corners, {}, radius, 0, roundSides - 1);
        }
        break;
    }
    }
    for (Vec2& corner : corners) {
        corner = piece.at + rotated(corner, piece.angle);
    }
    return corners;
}

std::vector<LiquidPiece> liquidPieces(Shape const& shape, Pose const& pose) {
    std::vector<LiquidPiece> pieces;
    for (ShapePiece const& piece : shape.pieces) {
        std::vector<Vec2> const corners = straightened(piece);
        LiquidPiece made;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            Vec2 const from = pose.toWorld(corners[i]);
            Vec2 const edge = pose.turned(corners[(i + 1) % corners.size()] - corners[i]);
            Vec2 const normal = -perpendicular(edge) / length(edge);
            made.sides.push_back({normal, dot(normal, from)});
        }
        pieces.push_back(std::move(made));
    }
    return pieces;
}

Bounds areaBounds(Shape const& shape, Pose const& pose) {
    std::vector<Vec2> corners;
    for (ShapePiece const& piece : shape.pieces) {
        for (Vec2 const corner : straightened(piece)) {
            corners.push_back(pose.toWorld(corner));
        }
    }
    return boundsOf(corners);
}

void findCuttingSides(LiquidPiece const& piece, Pose const& body, double radius, CuttingSides& found) {
    found.count = 0;
    found.dry = false;
    for (Side const& side : piece.sides) {
        double const outside = dot(side.normal, body.at) - side.offset;
        if (outside >= radius) {
            found.dry = true;
            return;
        }
        if (outside > -radius) {
            found.sides[found.count++] = {body.turnedBack(side.normal), -outside};
        }
    }
}

} // namespace trembler
