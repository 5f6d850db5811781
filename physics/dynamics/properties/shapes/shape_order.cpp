#include "physics/dynamics/properties/shapes/shape_order.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace trembler {
namespace {

bool lower(Vec2 a, Vec2 b) {
    return std::tie(a.y, a.x) < std::tie(b.y, b.x);
}

bool beginsLowest(ShapePiece const& piece) {
    return piece.form != ShapeForm::polygon || piece.corners.empty() ||
           std::min_element(piece.corners.begin(), piece.corners.end(), lower) == piece.corners.begin();
}

bool finite(ShapePiece const& piece) {
    return isFinite(piece.at) && std::isfinite(piece.angle) && std::isfinite(piece.radius) &&
           std::isfinite(piece.width) && std::isfinite(piece.height) &&
           std::all_of(piece.corners.begin(), piece.corners.end(),
                       [](Vec2 corner) { return isFinite(corner); });
}

// The measures that the form of the piece uses.
std::tuple<double, double, double> measuresOf(ShapePiece const& piece) {
    switch (piece.form) {
    case ShapeForm::circle:
        return {piece.radius, 0, 0};
    case ShapeForm::box:
        return {piece.width, piece.height, piece.angle};
    case ShapeForm::capsule:
        return {piece.radius, piece.width, piece.angle};
    case ShapeForm::polygon:
        return {0, 0, piece.angle};
    }
    return {0, 0, 0};
}

// From left to right; of pieces above one another, the one nearer to the middle first. Pieces that are equal
// in all of this may be in any order.
bool precedes(ShapePiece const& a, ShapePiece const& b) {
    auto const key = [](ShapePiece const& piece) {
        return std::tuple{piece.at.x, std::abs(piece.at.y), -piece.at.y, static_cast<int>(piece.form)};
    };
    if (key(a) != key(b)) {
        return key(a) < key(b);
    }
    if (measuresOf(a) != measuresOf(b)) {
        return measuresOf(a) < measuresOf(b);
    }
    return a.form == ShapeForm::polygon &&
           std::lexicographical_compare(a.corners.begin(), a.corners.end(), b.corners.begin(),
                                        b.corners.end(), lower);
}

bool goesFirst(ShapePiece const& a, ShapePiece const& b) {
    double const areaA = areaOf(a);
    double const areaB = areaOf(b);
    return areaA != areaB ? areaA > areaB : precedes(a, b);
}

} // namespace

bool isInOrder(Shape const& shape) {
    std::vector<ShapePiece> const& pieces = shape.pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!beginsLowest(pieces[i]) || (i > 0 && goesFirst(pieces[i], pieces[0])) ||
            (i > 1 && precedes(pieces[i], pieces[i - 1]))) {
            return false;
        }
    }
    return true;
}

Shape inOrder(Shape shape) {
    std::vector<ShapePiece>& pieces = shape.pieces;
    if (isInOrder(shape) || !std::all_of(pieces.begin(), pieces.end(), finite)) {
        return shape;
    }
    for (ShapePiece& piece : pieces) {
        if (!beginsLowest(piece)) {
            std::rotate(piece.corners.begin(),
                        std::min_element(piece.corners.begin(), piece.corners.end(), lower),
                        piece.corners.end());
        }
    }
    std::iter_swap(pieces.begin(), std::min_element(pieces.begin(), pieces.end(), goesFirst));
    std::sort(pieces.begin() + 1, pieces.end(), precedes);
    return shape;
}

} // namespace trembler
