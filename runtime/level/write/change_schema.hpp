// The JSON Schema of how exactly a level is computed: stated for all of it, or changed while it runs.
#pragma once

#include "runtime/world/registry.hpp"

#include <nlohmann/json.hpp>

namespace trembler {

/// An object with a detail level for each effect that has some; with `orNothing` also "", which leaves the
/// choice to the scene.
[[nodiscard]] nlohmann::ordered_json detailSchema(Registry const& registry, bool orNothing);
/// An entry of a solution's "changes".
[[nodiscard]] nlohmann::ordered_json changeSchema(Registry const& registry);

} // namespace trembler
