// Whether a wire may go from one object to another: for the player's wires, and for those that an author
// draws.
#pragma once

#include "puzzle/session/placements.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

/// The verdict on a wire between two objects of the store, in words for people. `connected`: there is a wire
/// between them already. Either id may be invalid. Any thread that may read the store.
[[nodiscard]] Verdict wireVerdict(Registry const& registry, Store const& store, ObjectId a, ObjectId b,
                                  bool connected);

} // namespace trembler
