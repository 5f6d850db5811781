// Makes the "connections" of a level, each by the effect that it belongs to.
#pragma once

#include "runtime/level/build/part_expander.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/world/registry.hpp"

#include <span>

namespace trembler {

/// Makes every connection of a level, and those inside composite parts, between the named objects, before the
/// first frame: by the effect whose kind it states, or else by the only effect that can connect the two
/// (Connector). If there is no such effect, or more than one, adds a problem at the connection's place in the
/// file. The order of the level's list does not matter. `connections` are all connections, also the ones that
/// the player has laid.
void layConnections(Registry const& registry, LevelFile const& level,
                    std::span<MadeConnection const> connections, Store& store, Problems& problems);

} // namespace trembler
