// The area of a liquid in the world, as convex pieces bounded by straight sides.
#pragma once

#include "physics/box_tree.hpp"
#include "physics/buoyancy/hulls/clip.hpp"
#include "physics/dynamics/properties/shape.hpp"

#include <vector>

namespace trembler {

/// The place of an object's frame.
struct Pose {
    Vec2 at;           ///< m
    double cosine = 1; ///< of its angle
    double sine = 0;

    Pose() = default;
    Pose(Vec2 position, double angle) : at(position), cosine(std::cos(angle)), sine(std::sin(angle)) {}
    [[nodiscard]] Vec2 toWorld(Vec2 v) const { return at + turned(v); }
    [[nodiscard]] Vec2 turned(Vec2 v) const { return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y}; }
    [[nodiscard]] Vec2 turnedBack(Vec2 v) const {
        return {cosine * v.x + sine * v.y, cosine * v.y - sine * v.x};
    }
};

/// A convex piece of liquid.
struct LiquidPiece {
    std::vector<Side> sides; ///< in the world; at most mostSides
};

/// A round piece is taken as a polygon of this many sides with the same area; its boundary is off by at most
/// 0.1 % of the radius.
inline constexpr std::size_t roundSides = 64;
inline constexpr std::size_t mostSides = roundSides + 2; // a capsule has two straight sides more

/// The pieces of a valid shape, placed in the world.
[[nodiscard]] std::vector<LiquidPiece> liquidPieces(Shape const& shape, Pose const& pose);

/// The box around all pieces.
[[nodiscard]] Bounds areaBounds(Shape const& shape, Pose const& pose);

/// The corners of a piece in the object's frame, anticlockwise, with round parts as above.
[[nodiscard]] std::vector<Vec2> straightened(ShapePiece const& piece);

/// The sides of a liquid piece that may cut a body, in the body's frame.
struct CuttingSides {
    std::array<Side, mostSides> sides;
    std::size_t count = 0;
    bool dry = false; ///< the body is wholly outside of the piece
};

/// `radius` (m) is that of a circle around the body's origin that holds all of it.
void findCuttingSides(LiquidPiece const& piece, Pose const& body, double radius, CuttingSides& found);

} // namespace trembler
