// The places of interest that a level's own geometry offers.
#pragma once

#include "insight/trial/level_under_test.hpp"
#include "runtime/level/model/level.hpp"

#include <optional>
#include <string>
#include <vector>

namespace trembler::insight {

/// A point, and on which side of it a part lies.
struct Place {
    enum class Kind : std::uint8_t { gap, goal, movable, magnet, liquid, fixed };
    enum class Side : std::uint8_t { above, below, left, right, middle };
    Kind kind = Kind::fixed;
    Side side = Side::above;
    Vec2 at;          ///< m
    double angle = 0; ///< rad, by which a part is turned to lie along the place, as across a gap
    std::string near; ///< the object, for people
};

/// In this order: gaps of up to 1.5 m between conductors, the narrowest first; around what the goals name,
/// and in their areas; above, below and beside what can move, and high above it; beside magnets; in liquids;
/// on top of what is fixed. A pure function of the level.
[[nodiscard]] std::vector<Place> placesOfInterest(LevelUnderTest const& level);

/// The part, turned by `turn` (rad) in addition to the place's angle, so that its outline touches the place,
/// or is centred on it; shifted into the nearest area for placing; and, if it overlaps something there,
/// farther away in steps of 5 cm. Nothing if it does not fit within 40 cm.
[[nodiscard]] std::optional<Placement> placedAt(LevelUnderTest const& level, Place const& place,
                                                std::string const& part, double turn);

} // namespace trembler::insight
