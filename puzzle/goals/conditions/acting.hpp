// The contacts and magnetic forces that act on objects: the causes of conditions on the places of objects.
#pragma once

#include "runtime/world/world.hpp"

#include <vector>

namespace trembler {

/// Adds the events of all contacts and magnetic forces that act at present on the objects `ids` (ascending).
void collectActing(World const& world, std::vector<ObjectId> const& ids, std::vector<EventId>& events);

} // namespace trembler
