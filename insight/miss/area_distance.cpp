#include "insight/miss/area_distance.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace trembler::insight {
namespace {

Vec2 nearestOn(Vec2 a, Vec2 b, Vec2 from) {
    Vec2 const along = b - a;
    double const square = dot(along, along);
    double const share = square > 0 ? std::clamp(dot(from - a, along) / square, 0.0, 1.0) : 0;
    return a + along * share;
}

} // namespace

Vec2 nearestIn(Area const& area, Vec2 from) {
    if (area.contains(from)) {
        return from;
    }
    if (area.box) {
        Vec2 const upper = area.box->corner + area.box->size;
        return {std::clamp(from.x, area.box->corner.x, upper.x),
                std::clamp(from.y, area.box->corner.y, upper.y)};
    }
    return nearestEdgeOf(area, from);
}

Vec2 nearestEdgeOf(Area const& area, Vec2 from) {
    std::vector<Vec2> corners = area.corners;
    if (area.box) {
        Vec2 const lower = area.box->corner;
        Vec2 const upper = lower + area.box->size;
        corners = {lower, {upper.x, lower.y}, upper, {lower.x, upper.y}};
    }
    Vec2 nearest = from;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Vec2 const at = nearestOn(corners[i], corners[(i + 1) % corners.size()], from);
        if (double const distance = length(at - from); distance < least) {
            least = distance;
            nearest = at;
        }
    }
    return nearest;
}

} // namespace trembler::insight
