// The obstacles to sound: the world's shapes as convex polygons.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

#include <span>
#include <vector>

namespace trembler {

struct Obstacle {
    ObjectId object;
    std::vector<Vec2> corners; ///< m, in the world, convex, anticlockwise; round pieces have about sixteen
    Vec2 low;                  ///< m, of its bounds
    Vec2 high;
    double density = 0; ///< kg/m³
};

/// Adds the pieces of a placed shape, with polygons around round pieces.
void addObstacles(std::vector<Obstacle>& obstacles, ObjectId object, Shape const& shape, Vec2 at,
                  double angle, double density);

/// Whether a point lies in the obstacle or on its edge.
[[nodiscard]] bool contains(Obstacle const& obstacle, Vec2 point);

/// The length of the part of a straight line that lies inside an obstacle, in m.
[[nodiscard]] double chordOf(Obstacle const& obstacle, Vec2 from, Vec2 to);

/// The shortest way from one point to another that stays out of one obstacle, in m, if neither lies in it.
[[nodiscard]] double detourAround(Obstacle const& obstacle, Vec2 from, Vec2 to);

inline constexpr int mostPatience = 20000;

/// The shortest way, in m, that stays out of all obstacles, along their corners; negative if there is none,
/// or if none was found within `patience` tests whether two points see each other.
[[nodiscard]] double shortestWay(std::span<Obstacle const* const> obstacles, Vec2 from, Vec2 to,
                                 int patience = mostPatience);

} // namespace trembler
