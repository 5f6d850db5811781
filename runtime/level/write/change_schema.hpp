// The JSON Schema of detail levels, periods and settings: for a whole level, or changed while it runs.
#pragma once

#include "runtime/world/registry.hpp"

#include <nlohmann/json.hpp>

namespace trembler {

/// An object with a detail level for each effect that has any; with `orNothing` also "", with which the scene
/// decides.
[[nodiscard]] nlohmann::ordered_json detailSchema(Registry const& registry, bool orNothing);
/// An entry of a solution's "changes".
[[nodiscard]] nlohmann::ordered_json changeSchema(Registry const& registry);

} // namespace trembler
