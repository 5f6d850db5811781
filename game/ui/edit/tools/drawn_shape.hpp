// Shapes as the designer draws them: from dragged corners and clicked polygons to pieces of a Shape.
#pragma once

#include "physics/dynamics/properties/shape.hpp"
#include "runtime/math/vec2.hpp"

#include <optional>
#include <span>
#include <vector>

namespace trembler::ui {

/// A new body: its place and its shape in its own frame.
struct DrawnShape {
    Vec2 at;          ///< m, in the world
    double angle = 0; ///< rad
    Shape shape;
};

// Each returns nothing if what was drawn is too small, or otherwise no shape that a level may state.

/// The box between two opposite corners.
[[nodiscard]] std::optional<DrawnShape> drawnBox(Vec2 from, Vec2 to);
/// The disc around a centre through a point of its edge.
[[nodiscard]] std::optional<DrawnShape> drawnDisc(Vec2 centre, Vec2 edge);
/// The capsule whose ends have these centres; a radius in m.
[[nodiscard]] std::optional<DrawnShape> drawnCapsule(Vec2 from, Vec2 to, double radius);
/// The polygon with these corners, either way round, convex or not, but with sides that do not cross. The
/// pieces are convex and have at most eight corners. Its place is the middle of its extent.
[[nodiscard]] std::optional<DrawnShape> drawnPolygon(std::span<Vec2 const> corners);

/// Whether any two sides of the closed polygon cross, or two corners lie in one place.
[[nodiscard]] bool crossesItself(std::span<Vec2 const> corners);

} // namespace trembler::ui
