// The line where the surface of a liquid cuts a body. It determines how buoyancy changes as the body moves.
#pragma once

#include "runtime/math/vec2.hpp"

#include <algorithm>

namespace trembler {

/// Integrals of 1, s and s² along the cuts, weighted by how much the liquid's side faces up there; s is the
/// coordinate across `up` from the frame's origin, towards the right if `up` points upwards.
struct Waterline {
    double length = 0; ///< m
    double first = 0;  ///< m²
    double second = 0; ///< m³

    Waterline& operator+=(Waterline const& o) {
        length += o.length, first += o.first, second += o.second;
        return *this;
    }
    /// Adds the cut from a to b on a side of the liquid whose outward normal is `normal`. `up` is the unit
    /// vector out of the liquid's surface. Sides that face down do not count.
    void add(Vec2 a, Vec2 b, Vec2 normal, Vec2 up) {
        double const weight = std::max(0.0, dot(normal, up)) * trembler::length(b - a);
        double const s = cross(a, up);
        double const t = cross(b, up);
        length += weight;
        first += weight * (s + t) / 2;
        second += weight * (s * s + s * t + t * t) / 3;
    }
};

} // namespace trembler
