// Drawing of ropes, chains, belts, rods, springs and wires, between two places or around two wheels.
#pragma once

#include "physics/dynamics/properties/joint_look.hpp"
#include "render/draw/canvas.hpp"

#include <span>
#include <vector>

namespace trembler::render {

/// Along a path. `own` and `none` draw nothing; a spring is drawn between the path's ends. `moved` in metres:
/// how far the links of a chain, or the marks of a belt, have run along the path.
void drawTie(Canvas& canvas, JointDrawn look, std::span<Point const> path, double moved = 0);

/// A coil spring between two places. `rest` is its length without force, in metres, from which the number of
/// its turns follows: a stretched spring keeps them.
void drawCoil(Canvas& canvas, Point a, Point b, double rest);

/// A wheel that a belt runs around.
struct BeltWheel {
    Point centre;
    double radius = 0; ///< m
};

/// The closed path of a belt around two wheels, anticlockwise around the first. A crossed one lets them turn
/// in opposite directions. Empty if they overlap too much for it.
[[nodiscard]] std::vector<Point> beltPath(BeltWheel const& first, BeltWheel const& second, bool crossed);

} // namespace trembler::render
