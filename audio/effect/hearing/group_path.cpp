#include "audio/effect/hearing/group_path.hpp"

#include "audio/effect/hearing/sound_path.hpp"

#include <algorithm>

namespace trembler {

// A convex wall that both outer lines of sight to the sources pass for at least c, nearer than the sources,
// is passed by each line in between for at least c times the cosine of half the angle: in polar coordinates
// around `to`, 1/r along a straight side is a mean of its values at the ends, weighted with a sum of at most
// the inverse of that cosine.
double shareAtMost(ObstacleField const& field, ObjectId exempt, Bounds const& sources, Vec2 to,
                   double lowestFrequency, double enough) {
    constexpr double thickEnough =
        2 * thinnestWall;          // the cosine is at least 0.7, and some is left for rounding
    constexpr double apart = 1e-3; // m: rounding must not put a source into a wall beside it
    Vec2 const near{std::clamp(to.x, sources.lower.x, sources.upper.x),
                    std::clamp(to.y, sources.lower.y, sources.upper.y)};
    double const reach = (1 - 1e-9) * length(near - to);
    if (reach < thickEnough) {
        return 1;
    }
    Vec2 right = sources.lower - to;
    Vec2 left = right;
    for (Vec2 const corner :
         {Vec2{sources.upper.x, sources.lower.y}, sources.upper, Vec2{sources.lower.x, sources.upper.y}}) {
        Vec2 const way = corner - to;
        right = cross(right, way) < 0 ? way : right;
        left = cross(left, way) > 0 ? way : left;
    }
    if (dot(right, left) <= 0) {
        return 1;
    }
    Vec2 const rightmost = to + reach / length(right) * right;
    Vec2 const leftmost = to + reach / length(left) * left;
    Bounds const around{sources.lower - Vec2{apart, apart}, sources.upper + Vec2{apart, apart}};
    double const mostAround = shareAround(0, lowestFrequency);
    double share = 1;
    int hope = 32; // the search ends if most walls stand in some of the lines only
    field.along(rightmost, to, [&](std::uint32_t number) {
        Obstacle const& wall = field.all()[number];
        if (wall.object != exempt && !around.meets({wall.low, wall.high}) &&
            chordOf(wall, rightmost, to) >= thickEnough && chordOf(wall, leftmost, to) >= thickEnough &&
            !contains(wall, to)) {
            share *= std::min(1.0, shareThrough(wall.density * thinnestWall, lowestFrequency) + mostAround);
            hope += 2;
        }
        return --hope > 0 && share >= enough;
    });
    return share;
}

} // namespace trembler
