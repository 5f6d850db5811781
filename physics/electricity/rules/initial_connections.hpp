// The connections that a world starts with: "connections" in a level, the thesis's invisible wires.
#pragma once

#include "runtime/object/object_id.hpp"

#include <optional>
#include <string>

namespace trembler {

class Store;

/// Adds a wire between two conductors, as the level states it; the graph counts it for CallerId::level(). Two
/// wires between one pair count twice, and a player can cut one at a time. Returns the fault and the expected
/// condition, in words, and changes nothing, if an object does not exist or is no conductor, or both are the
/// same; otherwise returns nothing. Before the first frame only, when all objects of the level exist; the
/// order of calls does not matter.
[[nodiscard]] std::optional<std::string> connectInitially(Store& store, ObjectId a, ObjectId b);

/// The same for two objects that are known to be different conductors.
void layWire(Store& store, ObjectId a, ObjectId b);

} // namespace trembler
