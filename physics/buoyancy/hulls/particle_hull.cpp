#include "physics/buoyancy/hulls/particle_hull.hpp"

#include "physics/buoyancy/hulls/disc.hpp"
#include "physics/buoyancy/hulls/exact_hull.hpp"
#include "physics/dynamics/properties/shapes/shape_order.hpp"

#include <algorithm>

namespace trembler {
namespace {

// The R2 sequence: steps by powers of the inverse of the plastic number, the root of x³ = x + 1.
class Spread {
public:
    /// The next point in the unit square.
    Vec2 next() {
        constexpr double stepX = 0.7548776662466927;
        constexpr double stepY = 0.5698402909980532;
        at_ = {fraction(at_.x + stepX), fraction(at_.y + stepY)};
        return at_;
    }

private:
    static double fraction(double x) { return x - std::floor(x); }
    Vec2 at_{0.5, 0.5};
};

bool insideSymmetric(ShapePiece const& piece, Vec2 p) {
    switch (piece.form) {
    case ShapeForm::circle:
        return length(p) <= piece.radius;
    case ShapeForm::capsule: {
        double const half = piece.width / 2 - piece.radius;
        return length({std::max(0.0, p.x - half), p.y}) <= piece.radius;
    }
    case ShapeForm::box:
    case ShapeForm::polygon:
        break;
    }
    return true;
}

// A quarter of the points in the quarter of a piece that is symmetric in both axes, and their mirror images.
void spreadSymmetric(ShapePiece const& piece, std::size_t quarter, std::vector<Vec2>& points) {
    Vec2 half{piece.radius, piece.radius};
    if (piece.form == ShapeForm::box) {
        half = {piece.width / 2, piece.height / 2};
    } else if (piece.form == ShapeForm::capsule) {
        half = {piece.width / 2, piece.radius};
    }
    Spread spread;
    for (std::size_t made = 0; made < quarter;) {
        Vec2 const unit = spread.next();
        Vec2 const p{unit.x * half.x, unit.y * half.y};
        if (insideSymmetric(piece, p)) {
            points.insert(points.end(), {p, {-p.x, p.y}, {-p.x, -p.y}, {p.x, -p.y}});
            ++made;
        }
    }
}

bool insidePolygon(std::span<Vec2 const> corners, Vec2 p) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (cross(corners[(i + 1) % corners.size()] - corners[i], p - corners[i]) < 0) {
            return false;
        }
    }
    return true;
}

void spreadOver(std::span<Vec2 const> corners, std::size_t count, std::vector<Vec2>& points) {
    // Turned so that the longest edge lies along x: then a convex polygon fills at least half of its
    // rectangle, so that only few points must be tried for each one inside.
    std::size_t longest = 0;
    auto const edge = [&](std::size_t i) { return corners[(i + 1) % corners.size()] - corners[i]; };
    for (std::size_t i = 1; i < corners.size(); ++i) {
        longest = lengthSquared(edge(i)) > lengthSquared(edge(longest)) ? i : longest;
    }
    Vec2 const along = edge(longest) / length(edge(longest));
    Vec2 lower{dot(corners[0], along), cross(along, corners[0])};
    Vec2 upper = lower;
    for (Vec2 const corner : corners) {
        Vec2 const p{dot(corner, along), cross(along, corner)};
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    Spread spread;
    for (std::size_t made = 0; made < count;) {
        Vec2 const unit = spread.next();
        Vec2 const local{lower.x + unit.x * (upper.x - lower.x), lower.y + unit.y * (upper.y - lower.y)};
        Vec2 const p = local.x * along + local.y * perpendicular(along);
        if (insidePolygon(corners, p)) {
            points.push_back(p);
            ++made;
        }
    }
}

// The points of a piece, moved so that their mean is its centroid.
std::vector<Vec2> pointsIn(ShapePiece const& piece, double share, int count) {
    auto const quarter =
        static_cast<std::size_t>(std::max(1.0, std::round(share * static_cast<double>(count) / 4)));
    std::vector<Vec2> points;
    if (piece.form != ShapeForm::polygon) {
        spreadSymmetric(piece, quarter, points);
        for (Vec2& point : points) {
            point = piece.at + rotated(point, piece.angle);
        }
        return points;
    }
    std::vector<Vec2> const corners = straightened(piece);
    spreadOver(corners, 4 * quarter, points);
    Vec2 mean;
    for (Vec2 const point : points) {
        mean += point / static_cast<double>(points.size());
    }
    Vec2 const missing = polygonMoments(corners).centroid() - mean;
    for (Vec2& point : points) {
        point += missing;
    }
    return points;
}

} // namespace

ParticleHull::ParticleHull(Shape const& shape, int count) : Hull(shapeMoments(shape), 0) {
    double const all = areaOf(shape);
    double reach = 0;
    Shape const ordered = inOrder(shape);
    for (ShapePiece const& piece : ordered.pieces) {
        double const area = areaOf(piece);
        std::vector<Vec2> const points = pointsIn(piece, area / all, count);
        double const radius = std::sqrt(area / (pi * static_cast<double>(points.size())));
        for (Vec2 const point : points) {
            particles_.push_back({point, radius});
            reach = std::max(reach, length(point) + radius);
        }
    }
    setRadius(reach);
}

Displacement ParticleHull::displaced(std::span<Side const> sides, Vec2 up) const {
    Displacement result;
    for (Particle const& particle : particles_) {
        Side const* cut = nullptr;
        double least = particle.radius; // distance from the particle's centre to the side, inside positive
        for (Side const& side : sides) {
            double const distance = side.offset - dot(side.normal, particle.at);
            if (distance < least) {
                least = distance;
                cut = &side;
            }
        }
        if (least <= -particle.radius) {
            continue;
        }
        if (cut == nullptr) {
            result.wet += discMoments(particle.radius).moved(particle.at);
            continue;
        }
        Segment const segment = discSegment(particle.radius, least);
        Vec2 const n = cut->normal;
        result.wet += segment.moments(n).moved(particle.at);
        Vec2 const middle = particle.at + least * n;
        Vec2 const chord = segment.halfChord * perpendicular(n);
        result.waterline.add(middle - chord, middle + chord, n, up);
    }
    return result;
}

} // namespace trembler
