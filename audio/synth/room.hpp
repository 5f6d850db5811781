// The echo of a level, estimated from its geometry and the materials of its walls.
#pragma once

#include "audio/effect/hearing/obstacles.hpp"
#include "physics/material.hpp"

#include <map>

namespace trembler {

class Store;

/// A level is flat; its room is assumed to be as deep as the square root of its area, with the average wall
/// as front and back.
struct RoomAcoustics {
    double area = 0;          ///< m², visible from the listener
    double volume = 0;        ///< m³
    double surface = 0;       ///< m², of all walls, openings included
    double absorption = 1;    ///< mean share of sound that the surface absorbs; an opening absorbs all
    double reverberation = 0; ///< s, until the echo has decayed by 60 dB
    double echo = 0;          ///< the power of the echo over that of the direct sound at a distance of 1 m

    friend bool operator==(RoomAcoustics const&, RoomAcoustics const&) = default;
};

/// The room around a point, by rays in all directions: Sabine's formula 0.161 V / (Σ S α + 4 m V), with 4 m =
/// 0.012/m for the air, and the steady echo of diffuse-field theory, 16 π (1 - α) / (S α) (Kuttruff, Room
/// Acoustics, 2000, Chapter 5). Walls that are not in `materials` count as plastic. Directions without a wall
/// within 25 m are open.
[[nodiscard]] RoomAcoustics roomAround(std::span<Obstacle const> walls,
                                       std::map<ObjectId, Material> const& materials, Vec2 point);

/// The same with the fixed objects of a world as walls.
[[nodiscard]] RoomAcoustics roomAround(Store const& store, Vec2 point);

} // namespace trembler
