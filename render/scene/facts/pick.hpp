// The object under a point, and how far the scene reaches.
#pragma once

#include "render/scene/facts/poses.hpp"
#include "render/scene/facts/shape_geometry.hpp"

#include <vector>

namespace trembler::render {

/// The topmost object under a point of the world, as drawScene draws it. If there is none, the object whose
/// edge is nearest within `tolerance` metres (of equally near ones the one that is drawn later); otherwise an
/// invalid id. Exact for all shapes. State the tolerance as a few pixels: canvas.metres(6). Reads the world;
/// may be called on any thread while the world is not stepped.
[[nodiscard]] ObjectId pick(World const& world, Point at, double tolerance = 0);

/// Distance in metres from a point of the world to the object as it is drawn; negative inside.
[[nodiscard]] double distanceTo(Facts const& facts, Pose const& pose, Point at);

/// The rectangle around an object's body, or the sign that stands for it; empty if it has neither.
[[nodiscard]] Extent extentOf(Facts const& facts, Pose const& pose);
/// The rectangles around all objects that have a body or a sign, in the order in which they are drawn.
[[nodiscard]] std::vector<Extent> extentsOf(World const& world);
/// The rectangle around a part that lies at `pose`.
[[nodiscard]] Extent extentOf(Prototype const& prototype, Pose const& pose);

/// The rectangle around everything that is drawn of an object, its drawing and its lights included, but not
/// its shadow and the outlines.
[[nodiscard]] Extent pictureExtentOf(Facts const& facts, Pose const& pose);

/// The rectangle around all objects that are seen, for Camera::fit; empty for an empty world. Of fixed bodies
/// much larger than the other objects (a floor without end) it includes only the part around these: the view
/// that a player wants at the start. Without moving objects that lie outside `bounds`, which have flown or
/// rolled away; empty bounds: there are none.
[[nodiscard]] Extent sceneFocus(World const& world, Extent const& bounds = {});

} // namespace trembler::render
