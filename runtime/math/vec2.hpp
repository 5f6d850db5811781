// A point or a direction in the plane, x to the right, y up. Lengths are in SI units.
#pragma once

#include "runtime/math/exact_math.hpp"

#include <cmath>

namespace trembler {

inline constexpr double pi = 3.14159265358979323846;

struct Vec2 {
    double x = 0;
    double y = 0;

    constexpr Vec2& operator+=(Vec2 o) { return x += o.x, y += o.y, *this; }
    constexpr Vec2& operator-=(Vec2 o) { return x -= o.x, y -= o.y, *this; }
    constexpr Vec2& operator*=(double s) { return x *= s, y *= s, *this; }
    friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
    friend constexpr Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }
    friend constexpr Vec2 operator*(double s, Vec2 a) { return {a.x * s, a.y * s}; }
    friend constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }
    friend constexpr bool operator==(Vec2 a, Vec2 b) = default;
};

[[nodiscard]] constexpr double dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}
/// The z component of the cross product: positive when b lies anticlockwise of a.
[[nodiscard]] constexpr double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}
/// a turned by a quarter anticlockwise.
[[nodiscard]] constexpr Vec2 perpendicular(Vec2 a) {
    return {-a.y, a.x};
}
[[nodiscard]] constexpr double lengthSquared(Vec2 a) {
    return dot(a, a);
}
[[nodiscard]] inline double length(Vec2 a) {
    return std::sqrt(dot(a, a));
}
[[nodiscard]] inline bool isFinite(Vec2 a) {
    return std::isfinite(a.x) && std::isfinite(a.y);
}
/// a turned anticlockwise by `angle` (rad).
[[nodiscard]] inline Vec2 rotated(Vec2 a, double angle) {
    auto const [c, s] = exactTurn(angle);
    return {c * a.x - s * a.y, s * a.x + c * a.y};
}

} // namespace trembler
