// The push that something guided, such as a button or a lever, lacks to close a gap of a circuit.
#pragma once

#include "insight/miss/current/circuit_gaps.hpp"
#include "insight/miss/lift/load.hpp"

#include <optional>

namespace trembler::insight {

struct NeededPush {
    ObjectId body;        ///< that is to be pushed: of the bodies that move as one the outermost
    Vec2 direction;       ///< unit, of the push in the middle of the way
    double force = 0;     ///< N, at the centre of mass, besides everything that acts now; above 0
    double turn = 0;      ///< rad, about which the body turns on the way; 0 on a slider
    bool touched = false; ///< whether anything movable touches the bodies, so that it is pushed too weakly
};

/// For a gap of the reason `apart`, one of whose ends is guided by a slider or a hinge of something fixed,
/// and otherwise held by springs and welds only: the least force that moves it over all of the way to the
/// other end, against the springs, its weight and the weight of what lies on it. Limits of the joint are not
/// looked at, nor are liquids and magnets: a run shows whether such a push suffices. Nothing if the end is
/// not guided so, does not meet the other end on its way, or should be moved by a motor or a coil that has no
/// current.
[[nodiscard]] std::optional<NeededPush> neededPush(World const& world, load::Neighbours const& neighbours,
                                                   CircuitGap const& gap);

} // namespace trembler::insight
