// The distance of a point from an area of a level.
#pragma once

#include "runtime/level/model/level.hpp"

namespace trembler::insight {

/// The point of an area that is nearest to `from`, in m; `from` itself if the area contains it.
[[nodiscard]] Vec2 nearestIn(Area const& area, Vec2 from);
/// The point of its edge that is nearest to `from`, in m.
[[nodiscard]] Vec2 nearestEdgeOf(Area const& area, Vec2 from);

} // namespace trembler::insight
