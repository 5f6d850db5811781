#include "physics/dynamics/engines/body_core.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

double sizeOf(ShapePiece const& piece) {
    switch (piece.form) {
    case ShapeForm::circle:
    case ShapeForm::capsule:
        return piece.radius;
    case ShapeForm::box:
        return std::min(piece.width, piece.height) / 2;
    case ShapeForm::polygon:
        break;
    }
    Vec2 middle;
    for (Vec2 const corner : piece.corners) {
        middle += corner / static_cast<double>(piece.corners.size());
    }
    double least = 1e9;
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
        Vec2 const side = piece.corners[(i + 1) % piece.corners.size()] - piece.corners[i];
        least = std::min(least, cross(side, middle - piece.corners[i]) / length(side));
    }
    return least;
}

Vec2 middleOf(ShapePiece const& piece) {
    if (piece.form != ShapeForm::polygon) {
        return piece.at;
    }
    Vec2 middle;
    for (Vec2 const corner : piece.corners) {
        middle += corner / static_cast<double>(piece.corners.size());
    }
    return piece.at + rotated(middle, piece.angle);
}

} // namespace

BodyCore coreOf(BodySpec const& spec) {
    BodyCore core;
    for (ShapePiece const& piece : spec.shape->pieces) {
        // Slightly smaller, so that contact detection finds the body that the core was stopped at.
        double const size = 0.9 * sizeOf(piece);
        if (size > core.radius) {
            core = {middleOf(piece) - spec.spread.centre, size};
        }
    }
    return core;
}

double extentOf(BodySpec const& spec) {
    double most = 0;
    for (ShapePiece const& piece : spec.shape->pieces) {
        double own = 0; // m, from the piece's origin
        switch (piece.form) {
        case ShapeForm::circle:
            own = piece.radius;
            break;
        case ShapeForm::capsule:
            own = piece.width / 2;
            break;
        case ShapeForm::box:
            own = std::hypot(piece.width, piece.height) / 2;
            break;
        case ShapeForm::polygon:
            for (Vec2 const corner : piece.corners) {
                own = std::max(own, length(corner));
            }
            break;
        }
        most = std::max(most, length(piece.at - spec.spread.centre) + own);
    }
    return most;
}

} // namespace trembler
