// Reads the section "world" of a level file.
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

/// Reads the properties of the world, "bounds" and "detail" into the level. Complains through `node`, with
/// its place, about all faults.
void readWorld(Registry const& registry, JsonNode const& node, LevelFile& level);

} // namespace trembler
