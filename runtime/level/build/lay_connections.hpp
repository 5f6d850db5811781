// Laying the "connections" of a level, each by the effect that it belongs to.
#pragma once

#include "runtime/level/json/json_document.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

/// Lays every connection of a level between the objects of that name, before the first frame: by the effect
/// whose kind it states, or else by the only one that can connect the two (Connector). Where there is none,
/// or more than one, that is a problem at the connection's place in the file. The order of the level's list
/// does not matter.
void layConnections(Registry const& registry, LevelFile const& level, Store& store, Problems& problems);

} // namespace trembler
