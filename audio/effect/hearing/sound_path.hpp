// The share of a sound that is transmitted between two points.
#pragma once

#include "audio/effect/hearing/obstacle_field.hpp"

namespace trembler {

/// The share of a sound's energy that is transmitted through a wall of that mass per area (kg/m²), by the
/// mass law for sound from all directions: 20 log10(m f) - 47 dB (Fahy and Gardonio, Sound and Structural
/// Vibration, 2007, Section 5.2). `frequency` in Hz. At most 1.
[[nodiscard]] double shareThrough(double massPerArea, double frequency);

/// The share of a sound's energy that passes around an obstacle on a way `detour` m longer than the straight
/// line, by Maekawa (Noise reduction by screens, Applied Acoustics 1, 1968): 10 log10(3 + 40 detour/λ) dB, at
/// most 24, as measured.
[[nodiscard]] double shareAround(double detour, double frequency);

/// How exactly walls are taken into account.
enum class PathDetail {
    straight, ///< the straight line: each obstacle on it transmits sound, and sound passes around it as if it
              ///< were alone
    around,   ///< also the shortest way around all obstacles together: no sound passes around the walls of a
              ///< closed room
};

/// m: an obstacle of which the line has a shorter part is no wall.
inline constexpr double thinnestWall = 0.01;

/// The mean square pressure at `to` over that at 1 m from a source at `from`, in free air 1/r². Obstacles of
/// the objects in `exempt` (the listener), and obstacles that contain an end, do not count. Two ends nearer
/// than 10 cm count as 10 cm apart. `frequency` in Hz. Echoes are left out. Along a straight line a share
/// less than `least` may be returned as 0, as the computation then stops early. `patience` is that of
/// shortestWay(); if it is exceeded, only the straight line counts. Thread-safe.
[[nodiscard]] double transmission(ObstacleField const& field, std::span<ObjectId const> exempt, Vec2 from,
                                  Vec2 to, double frequency, PathDetail detail, double least = 0,
                                  int patience = mostPatience);

} // namespace trembler
