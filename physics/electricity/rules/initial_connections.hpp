// The connections that a world starts with: "connections" in a level, the thesis's invisible wires.
#pragma once

#include "runtime/object/object_id.hpp"

#include <optional>
#include <string>

namespace trembler {

class Store;

/// Lays a wire between two conductors, as the level states it: the graph counts it under CallerId::level().
/// Twice the same pair is two wires, of which a player can cut one at a time. Returns the fault and what was
/// expected, in words, and changes nothing, if an object does not exist or is no conductor, or both are the
/// same; returns nothing if all is well. Before the first frame only, when all objects of the level exist;
/// the order of calls does not matter.
[[nodiscard]] std::optional<std::string> connectInitially(Store& store, ObjectId a, ObjectId b);

/// The same between two objects of which it is known that they are different conductors.
void layWire(Store& store, ObjectId a, ObjectId b);

} // namespace trembler
