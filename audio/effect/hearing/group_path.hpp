// An upper limit of the sound that reaches a listener from a group of sources.
#pragma once

#include "audio/effect/hearing/obstacle_field.hpp"

namespace trembler {

/// A limit: at most this share of the energy passes the walls on the straight line from any point of
/// `sources` to `to`, the distance not counted, as transmission() computes it for PathDetail::straight. 1 if
/// that is not known; a group of sources must be narrow, as seen from `to`. Obstacles of the object `exempt`
/// do not count. `lowestFrequency` in Hz, of the sources. Returns as soon as the limit is below `enough`.
/// Thread-safe.
[[nodiscard]] double shareAtMost(ObstacleField const& field, ObjectId exempt, Bounds const& sources, Vec2 to,
                                 double lowestFrequency, double enough);

} // namespace trembler
