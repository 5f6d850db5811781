#include "physics/dynamics/properties/shapes/corners.hpp"

namespace trembler {

std::vector<Vec2> straightCornersOf(ShapePiece const& piece) {
    if (piece.form == ShapeForm::polygon) {
        return piece.corners;
    }
    if (piece.form != ShapeForm::box) {
        return {};
    }
    double const w = piece.width / 2;
    double const h = piece.height / 2;
    return {{-w, -h}, {w, -h}, {w, h}, {-w, h}};
}

} // namespace trembler
