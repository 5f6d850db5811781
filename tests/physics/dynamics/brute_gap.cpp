#include "tests/physics/dynamics/brute_gap.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace trembler::test {
namespace {

constexpr double far = std::numeric_limits<double>::max();

// A piece as a convex polygon (of one corner or more) and a radius around it, in the world.
struct Rounded {
    std::vector<Vec2> corners;
    double radius = 0;
};

Rounded roundedOf(ShapePiece const& piece, Placed const& placed, double skin) {
    Rounded made;
    switch (piece.form) {
    case ShapeForm::circle:
        made = {{{0, 0}}, piece.radius};
        break;
    case ShapeForm::capsule: {
        double const half = piece.width / 2 - piece.radius;
        made = {{{-half, 0}, {half, 0}}, piece.radius};
        break;
    }
    case ShapeForm::box: {
        double const x = piece.width / 2;
        double const y = piece.height / 2;
        made = {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, skin};
        break;
    }
    case ShapeForm::polygon:
        made = {piece.corners, skin};
        break;
    }
    for (Vec2& corner : made.corners) {
        corner = placed.at + rotated(piece.at + rotated(corner, piece.angle), placed.angle);
    }
    return made;
}

double fromSegment(Vec2 point, Vec2 a, Vec2 b) {
    Vec2 const d = b - a;
    double const t = lengthSquared(d) == 0 ? 0 : std::clamp(dot(point - a, d) / lengthSquared(d), 0.0, 1.0);
    return length(point - a - t * d);
}

bool contains(std::vector<Vec2> const& corners, Vec2 point) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (cross(corners[(i + 1) % corners.size()] - corners[i], point - corners[i]) < 0) {
            return false;
        }
    }
    return corners.size() > 2;
}

bool crossEachOther(Vec2 p, Vec2 q, Vec2 r, Vec2 s) {
    return cross(q - p, r - p) * cross(q - p, s - p) < 0 && cross(s - r, p - r) * cross(s - r, q - r) < 0;
}

bool cornersOverlap(std::vector<Vec2> const& a, std::vector<Vec2> const& b) {
    for (auto const& [x, y] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
        for (Vec2 const corner : *x) {
            if (contains(*y, corner)) {
                return true;
            }
        }
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (crossEachOther(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) {
                return true;
            }
        }
    }
    return false;
}

double distance(std::vector<Vec2> const& a, std::vector<Vec2> const& b) {
    double least = far;
    for (auto const& [x, y] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
        for (Vec2 const corner : *x) {
            for (std::size_t i = 0; i < y->size(); ++i) {
                least = std::min(least, fromSegment(corner, (*y)[i], (*y)[(i + 1) % y->size()]));
            }
        }
    }
    return least;
}

// The shortest displacement out of a convex polygon is across one of its sides. Here it is the polygon of all
// differences between a point of one and a point of the other, whose sides are parallel to sides of the two.
double wayOut(std::vector<Vec2> const& a, std::vector<Vec2> const& b) {
    double least = far;
    for (auto const& [x, y] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
        for (std::size_t i = 0; x->size() > 1 && i < x->size(); ++i) {
            Vec2 const side = (*x)[(i + 1) % x->size()] - (*x)[i];
            Vec2 const outward = -perpendicular(side) / length(side);
            double deepest = 0;
            for (Vec2 const corner : *y) {
                deepest = std::max(deepest, -dot(outward, corner - (*x)[i]));
            }
            least = std::min(least, deepest);
        }
    }
    return least;
}

double gap(Rounded const& a, Rounded const& b) {
    double const cores =
        cornersOverlap(a.corners, b.corners) ? -wayOut(a.corners, b.corners) : distance(a.corners, b.corners);
    return cores - a.radius - b.radius;
}

} // namespace

double bruteGap(Placed const& a, Placed const& b, double skin) {
    double least = far;
    for (ShapePiece const& x : a.shape.pieces) {
        for (ShapePiece const& y : b.shape.pieces) {
            least = std::min(least, gap(roundedOf(x, a, skin), roundedOf(y, b, skin)));
        }
    }
    return least;
}

} // namespace trembler::test
