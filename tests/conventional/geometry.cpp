#include "tests/conventional/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trembler::conventional {
namespace {

double pointToSegment(Vec2 p, Vec2 a, Vec2 b) {
    Vec2 const along = b - a;
    double const size = dot(along, along);
    double const share = size > 0 ? std::clamp(dot(p - a, along) / size, 0.0, 1.0) : 0;
    return length(p - (a + share * along));
}

bool crossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    auto const side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p); };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool contains(Outline const& outline, Vec2 p) {
    if (outline.corners.size() < 3) {
        return false;
    }
    for (std::size_t i = 0; i < outline.corners.size(); ++i) {
        Vec2 const a = outline.corners[i];
        Vec2 const b = outline.corners[(i + 1) % outline.corners.size()];
        if (cross(b - a, p - a) < 0) {
            return false;
        }
    }
    return true;
}

double between(Outline const& a, Outline const& b) {
    if (contains(a, b.corners.front()) || contains(b, a.corners.front())) {
        return 0;
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.corners.size(); ++i) {
        Vec2 const p = a.corners[i];
        Vec2 const q = a.corners[(i + 1) % a.corners.size()];
        for (std::size_t j = 0; j < b.corners.size(); ++j) {
            Vec2 const r = b.corners[j];
            Vec2 const s = b.corners[(j + 1) % b.corners.size()];
            if (crossing(p, q, r, s)) {
                return 0;
            }
            least = std::min({least, pointToSegment(p, r, s), pointToSegment(r, p, q)});
        }
    }
    return std::max(0.0, least - a.radius - b.radius);
}

std::vector<Vec2> cornersOf(ShapePiece const& piece) {
    double const w = piece.width / 2;
    double const h = piece.height / 2;
    switch (piece.form) {
    case ShapeForm::circle:
        return {{0, 0}};
    case ShapeForm::capsule:
        return {{-(w - piece.radius), 0}, {w - piece.radius, 0}};
    case ShapeForm::box:
        return {{-w, -h}, {w, -h}, {w, h}, {-w, h}};
    case ShapeForm::polygon:
        return piece.corners;
    }
    return {};
}

} // namespace

std::vector<Outline> outlinesOf(Shape const& shape, Pose const& pose) {
    std::vector<Outline> all;
    for (ShapePiece const& piece : shape.pieces) {
        Outline outline;
        outline.radius =
            piece.form == ShapeForm::circle || piece.form == ShapeForm::capsule ? piece.radius : 0;
        for (Vec2 const corner : cornersOf(piece)) {
            outline.corners.push_back(pose.at + rotated(piece.at + rotated(corner, piece.angle), pose.angle));
        }
        all.push_back(std::move(outline));
    }
    return all;
}

double distance(std::vector<Outline> const& a, std::vector<Outline> const& b) {
    double least = std::numeric_limits<double>::infinity();
    for (Outline const& one : a) {
        for (Outline const& other : b) {
            least = std::min(least, between(one, other));
        }
    }
    return least;
}

} // namespace trembler::conventional
