// Where the names of objects stand, so that they hide neither one another nor small objects.
#pragma once

#include "render/draw/geometry.hpp"

#include <span>
#include <vector>

namespace trembler::render {

/// In pixels, y down.
struct NamedBox {
    Point low;  ///< of the rectangle around the object
    Point high; ///< of the same
    Point size; ///< width and height of its name
};

/// The middles of the names, in the order of the boxes: on an object that is larger than its name, else
/// beside it, where least is hidden; within the screen where there is room. A pure function, so names of
/// objects at rest stand still. Takes time with the square of their number; of more than 400 all stand on
/// their objects.
[[nodiscard]] std::vector<Point> namePlaces(std::span<NamedBox const> boxes, Point screen);

} // namespace trembler::render
