// The extensions that a level states to need, under "mods".
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/world/registry.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace trembler {

/// How many a level may name.
inline constexpr std::size_t mostExtensions = 50;

/// Reads a list of names. Complains about names that the registry does not have.
[[nodiscard]] std::vector<std::string> readExtensions(JsonNode const& node, Registry const& registry);

} // namespace trembler
