// What acts on objects: the causes of conditions on where objects are.
#pragma once

#include "runtime/world/world.hpp"

#include <vector>

namespace trembler {

/// Adds the events of what acts at present on `ids`, which are ascending: of what they touch, and of the
/// magnets that pull them.
void collectActing(World const& world, std::vector<ObjectId> const& ids, std::vector<EventId>& events);

} // namespace trembler
