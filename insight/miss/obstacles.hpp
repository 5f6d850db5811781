// Magnets as the causes for which an object did not get to its goal: off, too weak, or pulling elsewhere.
#pragma once

#include "insight/miss/miss.hpp"

namespace trembler::insight {

/// Adds to the miss of an object that a magnet can move what the magnets of the world lack: of an
/// electromagnet that is off the gaps of its circuit; of one that is on, if it pulls with less than the
/// object's weight, the missing force; of one that pulls it away from where it should be, with more than its
/// weight, that it holds it back. If the miss is about a magnet, only of that one; else of the one that
/// would pull the object most strongly. Does nothing for other objects.
void addObstacles(Miss& miss, World const& world, CircuitSight& circuits);

/// Adds to the miss of a current the open circuits of electromagnets that would move one of the conductors at
/// its gaps, as a coil moves the armature of its relay: conductors that joints guide, and electromagnets not
/// farther from them than 1 m.
void addSleepingCoils(Miss& miss, World const& world, CircuitSight& circuits);

} // namespace trembler::insight
