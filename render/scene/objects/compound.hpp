// Shapes of several pieces as one body: their common edge, the seams inside, and the same area without
// overlaps.
#pragma once

#include "render/scene/facts/shape_geometry.hpp"

#include <array>
#include <vector>

namespace trembler::render {

using Segment = std::array<Point, 2>;

/// The edges of the pieces as parts of the whole; all in the object's frame, metres.
struct CompoundEdges {
    std::vector<Segment> outer; ///< between the body and its surroundings
    std::vector<Segment> seams; ///< where pieces meet that overlap by less than `depth`
};

/// `depth` in metres: how far a piece must reach over another's edge to hide it. O(corners²).
[[nodiscard]] CompoundEdges edgesOf(Shape const& shape, double depth);

/// Convex parts that cover the same area once. Few where simple pieces are cut off round ones.
[[nodiscard]] std::vector<std::vector<Point>> withoutOverlaps(Shape const& shape);

/// The piece with the largest area; the shape must have one.
[[nodiscard]] ShapePiece const& largestPiece(Shape const& shape);

} // namespace trembler::render
