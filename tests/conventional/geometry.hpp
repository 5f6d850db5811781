// Distances between bodies by comparing every edge with every edge: slow, short, and without code of the
// engines.
#pragma once

#include "physics/dynamics/properties/shape.hpp"
#include "runtime/math/vec2.hpp"

#include <vector>

namespace trembler::conventional {

struct Pose {
    Vec2 at;            ///< m
    double angle = 0;   ///< rad
    bool there = false; ///< the object exists
};

/// A convex polygon, or a segment or a point, that is thicker by a radius all round. In the world.
struct Outline {
    std::vector<Vec2> corners;
    double radius = 0; ///< m
};

[[nodiscard]] std::vector<Outline> outlinesOf(Shape const& shape, Pose const& pose);
/// m; 0 where they overlap.
[[nodiscard]] double distance(std::vector<Outline> const& a, std::vector<Outline> const& b);

} // namespace trembler::conventional
