// Regular polygons, also with fewer or more corners than a shape may have.
#pragma once

#include "runtime/math/vec2.hpp"

#include <vector>

namespace trembler::test {

/// Corners (m) on a circle about the origin, from the positive x axis on.
inline std::vector<Vec2> ngon(int corners, double radius, bool clockwise = false) {
    std::vector<Vec2> made;
    for (int i = 0; i < corners; ++i) {
        made.push_back(rotated({radius, 0}, (clockwise ? -1 : 1) * 2 * pi * i / corners));
    }
    return made;
}

} // namespace trembler::test
