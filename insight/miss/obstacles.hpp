// The causes for which an object did not get to its goal: magnets that were off or too weak.
#pragma once

#include "insight/miss/miss.hpp"

namespace trembler::insight {

/// Adds to the miss of an object that a magnet can move what the magnets of the world lack: of an
/// electromagnet that is off the gaps of its circuit; of one that is on, if it pulls with less than the
/// object's weight, the missing force. If the miss is about a magnet, only of that one; else of the one
/// nearest to the object. Does nothing for other objects.
void addObstacles(Miss& miss, World const& world, CircuitSight& circuits);

} // namespace trembler::insight
