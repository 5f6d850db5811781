// Where bodies touch.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/facts/poses.hpp"
#include "render/scene/facts/shape_geometry.hpp"

#include <vector>

namespace trembler::render {

/// Where two placed shapes are nearest to each other: one point, or two at the ends of a line along which
/// they touch (within 5 mm). Points in the middle between the two edges, in the world.
[[nodiscard]] std::vector<Point> touchingPoints(Shape const& a, Pose const& poseA, Shape const& b,
                                                Pose const& poseB);

/// Length of the arrow of an impulse in N s: `unit` without one, and `unit` more for each tenfold above 0.01.
[[nodiscard]] double contactArrowLength(double impulse, double unit);
/// `unit` of the arrows in the scene, pixels.
inline constexpr double contactArrowUnit = 16;

/// Points with normals, and impulses as their lengths, where they are computed; otherwise a mark between
/// every pair that touches.
void drawContacts(Canvas& canvas, World const& world);

} // namespace trembler::render
