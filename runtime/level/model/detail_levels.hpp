// The detail levels that a level file, a recording and the schema may name.
#pragma once

#include "runtime/world/registry.hpp"

#include <map>
#include <string>
#include <vector>

namespace trembler {

/// The levels of every effect that has any, in the order in which their components are registered.
[[nodiscard]] std::map<std::string, std::vector<std::string>> detailLevels(Registry const& registry);

} // namespace trembler
