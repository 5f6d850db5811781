// Warnings about a running world for players and authors: the world is still computed, but not as intended.
#pragma once

#include "runtime/world/world.hpp"

#include <string>
#include <vector>

namespace trembler {

/// One line for each warning about the present world: an engine that gave up, or an object that is held
/// still. Usually none.
[[nodiscard]] std::vector<std::string> warningsOf(World const& world);

} // namespace trembler
