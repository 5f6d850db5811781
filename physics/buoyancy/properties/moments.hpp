// Area, first and second moments of a region of the plane.
#pragma once

#include "runtime/math/vec2.hpp"

#include <span>

namespace trembler {

/// Integrals over a region, about the origin of the frame in which it is described. Those of several regions
/// can be added.
struct AreaMoments {
    double area = 0; ///< m²
    Vec2 first;      ///< m³: ∫x, ∫y
    double xx = 0;   ///< m⁴: ∫x²
    double xy = 0;   ///< m⁴: ∫xy
    double yy = 0;   ///< m⁴: ∫y²

    AreaMoments& operator+=(AreaMoments const& o) {
        area += o.area, first += o.first;
        xx += o.xx, xy += o.xy, yy += o.yy;
        return *this;
    }
    friend AreaMoments operator*(double s, AreaMoments const& m) {
        return {s * m.area, s * m.first, s * m.xx, s * m.xy, s * m.yy};
    }
    /// The area must not be zero.
    [[nodiscard]] Vec2 centroid() const { return first / area; }
    /// The same region moved by `by`.
    [[nodiscard]] AreaMoments moved(Vec2 by) const {
        return {area, first + area * by, xx + 2 * first.x * by.x + area * by.x * by.x,
                xy + first.x * by.y + first.y * by.x + area * by.x * by.y,
                yy + 2 * first.y * by.y + area * by.y * by.y};
    }
};

/// The moments of the triangle (origin, p, q), negative if it runs clockwise.
[[nodiscard]] inline AreaMoments triangleMoments(Vec2 p, Vec2 q) {
    double const area = cross(p, q) / 2;
    double const sixth = area / 6;
    return {area, area / 3 * (p + q), sixth * (p.x * p.x + p.x * q.x + q.x * q.x),
            sixth / 2 * (2 * p.x * p.y + p.x * q.y + q.x * p.y + 2 * q.x * q.y),
            sixth * (p.y * p.y + p.y * q.y + q.y * q.y)};
}

/// The moments of a polygon, negative if its corners run clockwise.
[[nodiscard]] inline AreaMoments polygonMoments(std::span<Vec2 const> corners) {
    AreaMoments sum;
    if (corners.size() < 3) {
        return sum;
    }
    Vec2 const origin = corners.front(); // a fan from here loses no precision far from the origin
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        sum += triangleMoments(corners[i] - origin, corners[i + 1] - origin);
    }
    return sum.moved(origin);
}

} // namespace trembler
