// What a player or an author should know of a world that went on all the same.
#pragma once

#include "runtime/world/world.hpp"

#include <string>
#include <vector>

namespace trembler {

/// A line each; none, as a rule. Of the world as it stands: which engine had to give up, and what stands
/// still.
[[nodiscard]] std::vector<std::string> warningsOf(World const& world);

} // namespace trembler
