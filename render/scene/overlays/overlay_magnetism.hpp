// Magnetism over the scene: the forces that act, and the field that causes them.
#pragma once

#include "render/draw/canvas.hpp"
#include "runtime/world/world.hpp"

namespace trembler::render {

/// Length in metres of an arrow that shows a force, in newtons: logarithmic, as forces span decades. 0 for no
/// force (and for one that is not finite); a force one decade above `leastForce` has an arrow of `decade`
/// metres.
[[nodiscard]] double arrowLength(double newtons, double decade);
/// N; forces below it have arrows of nearly no length.
inline constexpr double leastForce = 0.01;
/// `decade` of all arrows of forces in the scene, pixels.
inline constexpr double forceDecade = 20;

/// An arrow at each point where a magnetic force acts.
void drawMagneticForces(Canvas& canvas, World const& world);

/// Field lines of all active poles within about the view, with arrows from north to south.
void drawFieldLines(Canvas& canvas, World const& world);

} // namespace trembler::render
