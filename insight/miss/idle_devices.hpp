// Motors and electromagnets without current that could move a body.
#pragma once

#include "insight/miss/lift/load.hpp"
#include "insight/miss/miss.hpp"

#include <span>
#include <vector>

namespace trembler::insight {

/// m: an electromagnet farther than this from a magnetic body, middle to middle, is not said to move it.
inline constexpr double coilReach = 1;

/// Whether an object with a motor or a coil has no current.
[[nodiscard]] bool isIdle(World const& world, ObjectId device);

/// The body and all movable ones that joints tie it to, through others as well; ascending. Empty if it is
/// fixed or has no shape.
[[nodiscard]] std::vector<ObjectId> tiedBodies(World const& world, load::Neighbours const& neighbours,
                                               ObjectId body);

/// The idle devices that act on one of the bodies when they have current: motors that turn it, or bear their
/// reaction on it, and electromagnets in reach of one that can be magnetised. Ascending.
[[nodiscard]] std::vector<ObjectId> idleDevicesOf(World const& world, std::span<ObjectId const> bodies);

/// What the circuit of an idle device lacks: gaps, or a source; without names.
[[nodiscard]] Miss missOfIdle(World const& world, ObjectId device, CircuitSight& circuits);

} // namespace trembler::insight
