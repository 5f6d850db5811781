// Points and poses of the drawing layer, independent of any physics engine's vector types.
#pragma once

#include <cmath>

namespace trembler::render {

/// A point or a vector; metres with y up in the world, pixels with y down on the screen.
struct Point {
    double x = 0;
    double y = 0;

    friend constexpr bool operator==(Point const&, Point const&) = default;
    friend constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Point operator*(double factor, Point a) { return {factor * a.x, factor * a.y}; }
};

[[nodiscard]] constexpr double dot(Point a, Point b) {
    return a.x * b.x + a.y * b.y;
}
[[nodiscard]] inline double length(Point a) {
    return std::hypot(a.x, a.y);
}
[[nodiscard]] inline bool finite(Point a) {
    return std::isfinite(a.x) && std::isfinite(a.y);
}

/// Where a shape's own frame lies in the world: position in metres, angle in radians, anticlockwise.
struct Pose {
    Point at;
    double angle = 0;
};

/// A point of the shape's own frame, in the world.
[[nodiscard]] inline Point toWorld(Pose const& pose, Point local) {
    double const c = std::cos(pose.angle);
    double const s = std::sin(pose.angle);
    return {pose.at.x + c * local.x - s * local.y, pose.at.y + s * local.x + c * local.y};
}

} // namespace trembler::render
