// The connections that a world starts with: "connections" in a level, the thesis's invisible wires.
#pragma once

#include "runtime/object/object_id.hpp"

namespace trembler {

class Store;

/// Adds a wire between two objects that refuseWire() accepts, as the level states it; the graph counts it for
/// CallerId::level(). Two wires between one pair count twice, and a player can cut one at a time. Before the
/// first frame only, when all objects of the level exist; the order of calls does not matter.
void layWire(Store& store, ObjectId a, ObjectId b);

} // namespace trembler
