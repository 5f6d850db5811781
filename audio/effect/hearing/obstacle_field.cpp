#include "audio/effect/hearing/obstacle_field.hpp"

#include <cmath>

namespace trembler {
namespace {

constexpr double slack = 1e-6; // m: rounding must not make a line miss an obstacle that it meets

std::vector<Bounds> boundsOf(std::span<Obstacle const> obstacles) {
    std::vector<Bounds> bounds;
    bounds.reserve(obstacles.size());
    for (Obstacle const& obstacle : obstacles) {
        bounds.push_back({obstacle.low, obstacle.high});
    }
    return bounds;
}

// A segment misses a box if one of three lines divides them: along x, along y, along itself.
bool touches(Bounds const& box, Vec2 middle, Vec2 half) {
    Vec2 const boxHalf = (box.upper - box.lower) / 2 + Vec2{slack, slack};
    Vec2 const apart = middle - (box.lower + box.upper) / 2;
    double const x = std::abs(half.x);
    double const y = std::abs(half.y);
    return std::abs(apart.x) <= boxHalf.x + x && std::abs(apart.y) <= boxHalf.y + y &&
           std::abs(cross(half, apart)) <= boxHalf.x * y + boxHalf.y * x + slack * slack;
}

} // namespace

ObstacleField::ObstacleField(std::span<Obstacle const> obstacles)
    : obstacles_(obstacles), tree_(boundsOf(obstacles)) {}

bool ObstacleField::along(Vec2 from, Vec2 to, std::function<bool(std::uint32_t)> const& visit) const {
    Vec2 const middle = (from + to) / 2;
    Vec2 const half = (to - from) / 2;
    return tree_.visitIf([&](Bounds const& box) { return touches(box, middle, half); }, visit);
}

} // namespace trembler
