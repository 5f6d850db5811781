#include "game/ui/play/view/area_name_place.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace trembler::ui {
namespace {

using render::Extent;
using render::Point;

/// A place on an object that holds the whole name is worse than a free one and better than an edge.
constexpr double backgroundCost = 0.15;
/// A name from one object to another hides the way between them, which may be the way into the area.
constexpr double passageCost = 0.5;
/// Of each line of letters by which the name is farther from the area; a share of the name's own size.
constexpr double lineCost = 0.03;
constexpr int mostLines = 2;

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

/// Whether objects lie under both ends of the name and there is a free place between them.
bool hidesAPassage(Extent const& name, std::span<Extent const> objects) {
    double const middle = name.centre().x;
    bool left = false;
    bool right = false;
    for (Extent const& object : objects) {
        if (!object.overlaps(name)) {
            continue;
        }
        if (object.lower.x <= middle && object.upper.x >= middle) {
            return false;
        }
        left = left || (object.lower.x <= name.lower.x && object.upper.x < middle);
        right = right || (object.upper.x >= name.upper.x && object.lower.x > middle);
    }
    return left && right;
}

} // namespace

Point areaNamePlace(render::Camera const& camera, Extent const& area, Point size,
                    std::span<Extent const> objects, std::span<Placed const> cards) {
    Point const half = (0.5 / camera.pixelsPerMetre) * size;
    double const wide = std::max(area.half().x - half.x, 0.0);
    // Last the middles that put the name at a corner of the area, partly beside it.
    std::array const columns{0.0, -0.5 * wide, 0.5 * wide, -wide, wide, -area.half().x, area.half().x};
    struct Row {
        double y;
        double cost;
    };
    std::vector<Row> rows{{area.upper.y + half.y, 0},
                          {area.upper.y - half.y, 0},
                          {area.lower.y - half.y, 0},
                          {area.lower.y + half.y, 0}};
    for (int line = 1; line <= mostLines; ++line) {
        double const away = (2 * line + 1) * half.y;
        rows.push_back({area.upper.y + away, line * lineCost});
        rows.push_back({area.lower.y - away, line * lineCost});
    }
    double const whole = std::max(4 * half.x * half.y, 1e-12);
    Point best{area.centre().x, rows.front().y};
    double least = std::numeric_limits<double>::infinity();
    for (Row const& row : rows) {
        for (double const column : columns) {
            Point const at{area.centre().x + column, row.y};
            Point const pixel = camera.toScreen(at);
            Rect const shown{pixel - 0.5 * size, pixel + 0.5 * size};
            bool const seen = shown.low.x >= 0 && shown.low.y >= 0 && shown.high.x <= camera.viewport.width &&
                              shown.high.y <= camera.viewport.height &&
                              std::none_of(cards.begin(), cards.end(),
                                           [&](Placed const& card) { return card.rect.overlaps(shown); });
            if (!seen) {
                continue;
            }
            Extent name;
            name.add(at - half);
            name.add(at + half);
            double const passage = hidesAPassage(name, objects) ? passageCost : 0;
            double const cost = areaNameCover(name, objects) / whole + row.cost + passage;
            if (cost < least) {
                least = cost;
                best = at;
            }
        }
    }
    return best;
}

} // namespace trembler::ui
