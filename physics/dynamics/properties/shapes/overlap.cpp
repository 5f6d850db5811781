#include "physics/dynamics/properties/shapes/overlap.hpp"

#include <box2d/b2_distance.h>

#include <algorithm>
#include <limits>

namespace trembler {
namespace {

// A piece for the distance algorithm: the hull of some points, rounded by a radius.
struct RoundedHull {
    std::vector<Vec2> points; // m, in the world
    double radius = 0;
};

RoundedHull hullOf(ShapePiece const& piece, PlacedShape const& placed, double shrink) {
    RoundedHull hull;
    switch (piece.form) {
    case ShapeForm::circle:
        hull.points = {{0, 0}};
        hull.radius = std::max(0.0, piece.radius - shrink);
        break;
    case ShapeForm::capsule: {
        double const half = std::max(0.0, piece.width / 2 - piece.radius);
        hull.points = {{-half, 0}, {half, 0}};
        hull.radius = std::max(0.0, piece.radius - shrink);
        break;
    }
    case ShapeForm::box: {
        double const w = std::max(0.0, piece.width / 2 - shrink);
        double const h = std::max(0.0, piece.height / 2 - shrink);
        hull.points = {{-w, -h}, {w, -h}, {w, h}, {-w, h}};
        break;
    }
    case ShapeForm::polygon: {
        Vec2 middle;
        for (Vec2 const corner : piece.corners) {
            middle += corner / static_cast<double>(piece.corners.size());
        }
        for (Vec2 const corner : piece.corners) {
            Vec2 const arm = corner - middle;
            double const reach = length(arm);
            hull.points.push_back(middle + arm * (reach > shrink ? 1 - shrink / reach : 0));
        }
        break;
    }
    }
    for (Vec2& point : hull.points) {
        point = placed.at + rotated(piece.at + rotated(point, piece.angle), placed.angle);
    }
    return hull;
}

ShapeGap gapOf(RoundedHull const& a, RoundedHull const& b) {
    // Places are taken relative to one hull, as the library computes in single precision.
    Vec2 const origin = a.points.front();
    std::array<b2Vec2, 8> pointsA;
    std::array<b2Vec2, 8> pointsB;
    auto const fill = [&](RoundedHull const& hull, std::array<b2Vec2, 8>& points) {
        for (std::size_t i = 0; i < std::min<std::size_t>(8, hull.points.size()); ++i) {
            Vec2 const p = hull.points[i] - origin;
            points[i].Set(static_cast<float>(p.x), static_cast<float>(p.y));
        }
        return static_cast<int32>(std::min<std::size_t>(8, hull.points.size()));
    };
    b2DistanceInput input;
    input.proxyA.Set(pointsA.data(), fill(a, pointsA), static_cast<float>(a.radius));
    input.proxyB.Set(pointsB.data(), fill(b, pointsB), static_cast<float>(b.radius));
    input.transformA.SetIdentity();
    input.transformB.SetIdentity();
    input.useRadii = true;
    b2SimplexCache cache;
    cache.count = 0;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    auto const placed = [&](b2Vec2 const& point) { return origin + Vec2{point.x, point.y}; };
    return {output.distance, placed(output.pointA), placed(output.pointB)};
}

} // namespace

bool overlap(PlacedShape const& a, PlacedShape const& b, double allowed) {
    for (ShapePiece const& pieceA : a.shape.pieces) {
        RoundedHull const hullA = hullOf(pieceA, a, allowed / 2);
        for (ShapePiece const& pieceB : b.shape.pieces) {
            if (!(gapOf(hullA, hullOf(pieceB, b, allowed / 2)).width > 0)) {
                return true;
            }
        }
    }
    return false;
}

ShapeGap gapBetween(PlacedShape const& a, PlacedShape const& b) {
    ShapeGap least{std::numeric_limits<double>::max(), {}, {}};
    for (ShapePiece const& pieceA : a.shape.pieces) {
        RoundedHull const hullA = hullOf(pieceA, a, 0);
        for (ShapePiece const& pieceB : b.shape.pieces) {
            ShapeGap const gap = gapOf(hullA, hullOf(pieceB, b, 0));
            if (gap.width < least.width) {
                least = gap;
            }
        }
    }
    return least;
}

std::pair<Vec2, Vec2> extentOf(PlacedShape const& placed) {
    constexpr double far = std::numeric_limits<double>::max();
    Vec2 lower{far, far};
    Vec2 upper{-far, -far};
    for (ShapePiece const& piece : placed.shape.pieces) {
        RoundedHull const hull = hullOf(piece, placed, 0);
        for (Vec2 const p : hull.points) {
            lower = {std::min(lower.x, p.x - hull.radius), std::min(lower.y, p.y - hull.radius)};
            upper = {std::max(upper.x, p.x + hull.radius), std::max(upper.y, p.y + hull.radius)};
        }
    }
    return {lower, upper};
}

} // namespace trembler
