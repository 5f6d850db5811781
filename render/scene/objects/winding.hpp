// Electromagnets: where the winding sits on a body, and how it is drawn.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/facts/facts.hpp"

#include <array>

namespace trembler::render {

/// The winding in the object's frame.
struct Winding {
    Point from;                     ///< middle of the end away from the active pole
    Point to;                       ///< middle of the other end
    Point axis;                     ///< unit, from `from` to `to`
    double halfWidth = 0;           ///< m
    std::array<Point, 2> terminals; ///< where its wires are fastened
};

/// Around the largest piece, along the line of its poles; without poles, along its longer side. Around a box
/// always along one of its sides. Needs a shape.
[[nodiscard]] Winding windingOf(Facts const& facts);

/// Copper on the core, with terminals; lit, and its pole named, by the share of its strength that acts.
void drawWinding(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style);

} // namespace trembler::render
