// The share of a sound that arrives on its way between two points.
#pragma once

#include "audio/effect/hearing/obstacle_field.hpp"

namespace trembler {

/// The share of a sound's energy that goes through a wall of that mass per area (kg/m²), by the mass law for
/// sound from all directions: 20 log10(m f) - 47 dB (Fahy and Gardonio, Sound and Structural Vibration, 2007,
/// Section 5.2). `frequency` in Hz. 1 at the most.
[[nodiscard]] double shareThrough(double massPerArea, double frequency);

/// The share of a sound's energy that gets around an obstacle by a way that is `detour` m longer than the
/// straight one, by Maekawa (Noise reduction by screens, Applied Acoustics 1, 1968): 10 log10(3 + 40
/// detour/λ) dB, 24 at the most, as measured.
[[nodiscard]] double shareAround(double detour, double frequency);

/// How exactly walls are taken into account.
enum class PathDetail {
    straight, ///< the straight line: each obstacle on it lets sound through, and around itself as if it stood
              ///< alone
    around,   ///< besides, the shortest way around all obstacles together: a closed room is closed
};

/// The mean square pressure at `to` over that at 1 m from a source at `from`, in free air 1/r². Obstacles of
/// the objects in `exempt` (the listener), and those that an end lies in, are not in the way. Two ends nearer
/// than 10 cm count as 10 cm apart. `frequency` in Hz. Echoes are left out. Along a straight line a share
/// less than `least` may be returned as 0: walls are not counted on once it no longer matters. `patience` is
/// that of shortestWay(); where it runs out, only the straight line counts. Thread-safe.
[[nodiscard]] double transmission(ObstacleField const& field, std::span<ObjectId const> exempt, Vec2 from,
                                  Vec2 to, double frequency, PathDetail detail, double least = 0,
                                  int patience = mostPatience);

} // namespace trembler
