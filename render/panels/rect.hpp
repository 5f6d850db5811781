// A rectangle of the window.
#pragma once

#include "render/draw/geometry.hpp"

namespace trembler::render {

/// Pixels from the top left.
struct Rect {
    Point low;
    Point high;

    [[nodiscard]] bool contains(Point p) const {
        return p.x >= low.x && p.x < high.x && p.y >= low.y && p.y < high.y;
    }
    [[nodiscard]] bool overlaps(Rect const& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
    }
    [[nodiscard]] Point middle() const { return 0.5 * (low + high); }
};

} // namespace trembler::render
