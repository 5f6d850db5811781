#include "physics/buoyancy/hulls/disc.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {

AreaMoments sectorMoments(double radius, Vec2 p, Vec2 q) {
    double const turn = std::atan2(cross(p, q), dot(p, q));
    Vec2 const a = p / length(p);
    Vec2 const b = q / length(q);
    double const square = radius * radius;
    double const quarter = square * square / 4;
    // Half of the double angles' differences: sin 2φ = 2 sin φ cos φ.
    double const sines = (b.x * b.y - a.x * a.y) / 2;
    AreaMoments sector;
    sector.area = square * turn / 2;
    sector.first = square * radius / 3 * Vec2{b.y - a.y, a.x - b.x};
    sector.xx = quarter * (turn / 2 + sines);
    sector.yy = quarter * (turn / 2 - sines);
    sector.xy = quarter * (b.y * b.y - a.y * a.y) / 2;
    return sector;
}

AreaMoments discMoments(double radius) {
    double const square = radius * radius;
    double const quarter = pi * square * square / 4;
    return {pi * square, {}, quarter, 0, quarter};
}

Segment discSegment(double radius, double distance) {
    double const d = std::clamp(distance / radius, -1.0, 1.0);
    double const s = std::sqrt((1 - d) * (1 + d));
    double const square = radius * radius;
    double const angle = std::acos(-d); // half the angle that the segment takes up
    Segment segment;
    segment.area = square * (angle + d * s);
    segment.halfChord = radius * s;
    // ∫ over the segment of the coordinate against the normal is (2/3) (r s)³.
    double const first = 2.0 / 3.0 * square * radius * s * s * s;
    segment.offset = segment.area > 0 ? std::min(first / segment.area, radius) : radius;
    segment.along = square * square / 4 * (angle + d * s * (2 * d * d - 1));
    segment.across = square * square / 4 * (angle + d * s * (5 - 2 * d * d) / 3);
    return segment;
}

AreaMoments Segment::moments(Vec2 normal) const {
    double const nx = normal.x * normal.x;
    double const ny = normal.y * normal.y;
    return {area, -area * offset * normal, along * nx + across * ny, (along - across) * normal.x * normal.y,
            along * ny + across * nx};
}

DiscSide discSide(double radius, Vec2 from, Vec2 to) {
    DiscSide side;
    Vec2 const along = to - from;
    double const a = lengthSquared(along);
    double const b = dot(from, along);
    double const c = lengthSquared(from) - radius * radius;
    double const discriminant = b * b - a * c;
    if (!(a > 0)) {
        return side;
    }
    double const root = discriminant > 0 ? std::sqrt(discriminant) : 0;
    double const enters = std::clamp((-b - root) / a, 0.0, 1.0);
    double const leaves = std::clamp((-b + root) / a, 0.0, 1.0);
    if (discriminant <= 0 || !(leaves > enters)) {
        if (lengthSquared(from) > 0 && lengthSquared(to) > 0) {
            side.moments = sectorMoments(radius, from, to);
        }
        return side;
    }
    side.cuts = true;
    side.chord = {enters > 0 ? from + enters * along : from, leaves < 1 ? from + leaves * along : to};
    if (enters > 0) {
        side.moments += sectorMoments(radius, from, side.chord[0]);
    }
    side.moments += triangleMoments(side.chord[0], side.chord[1]);
    if (leaves < 1) {
        side.moments += sectorMoments(radius, side.chord[1], to);
    }
    return side;
}

} // namespace trembler
