#include "game/ui/play/view/area_name_place.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace trembler::ui {
namespace {

using render::Extent;
using render::Point;

/// A place on an object that holds the whole name is worse than a free one and better than an edge.
constexpr double backgroundCost = 0.05;

/// m^2 of the objects under the name.
double areaNameCover(Extent const& name, std::span<Extent const> objects) {
    double sum = 0;
    for (Extent const& object : objects) {
        double const across = std::min(name.upper.x, object.upper.x) - std::max(name.lower.x, object.lower.x);
        double const up = std::min(name.upper.y, object.upper.y) - std::max(name.lower.y, object.lower.y);
        if (across <= 0 || up <= 0) {
            continue;
        }
        bool const behind = object.lower.x <= name.lower.x && object.upper.x >= name.upper.x &&
                            object.lower.y <= name.lower.y && object.upper.y >= name.upper.y;
        sum += (behind ? backgroundCost : 1) * across * up;
    }
    return sum;
}

} // namespace

Point areaNamePlace(render::Camera const& camera, Extent const& area, Point size,
                    std::span<Extent const> objects) {
    Point const half = (0.5 / camera.pixelsPerMetre) * size;
    double const wide = std::max(area.half().x - half.x, 0.0);
    std::array const rows{area.upper.y + half.y, area.upper.y - half.y, area.lower.y - half.y,
                          area.lower.y + half.y};
    constexpr std::array shares{0.0, -0.5, 0.5, -1.0, 1.0}; // of the way from the middle to a corner
    Point best{area.centre().x, rows.front()};
    double least = std::numeric_limits<double>::infinity();
    for (double const y : rows) {
        for (double const share : shares) {
            Point const at{area.centre().x + share * wide, y};
            Point const pixel = camera.toScreen(at);
            bool const seen = pixel.x >= 0.5 * size.x && pixel.y >= 0.5 * size.y &&
                              pixel.x <= camera.viewport.width - 0.5 * size.x &&
                              pixel.y <= camera.viewport.height - 0.5 * size.y;
            Extent name;
            name.add(at - half);
            name.add(at + half);
            if (double const cover = areaNameCover(name, objects); seen && cover < least) {
                least = cover;
                best = at;
            }
        }
    }
    return best;
}

} // namespace trembler::ui
