// The JSON Schema of level files, goals included: the output of `trembler schema` and
// levels/level.schema.json.
#pragma once

#include "runtime/world/registry.hpp"

#include <nlohmann/json.hpp>

namespace trembler {

/// A schema whose "$defs" hold "condition" and the definitions that it needs. Refers to the definitions
/// "name" and "area" of the level's schema.
[[nodiscard]] nlohmann::ordered_json goalSchema();

/// The whole schema of a level file.
[[nodiscard]] nlohmann::ordered_json levelSchema(Registry const& registry);

} // namespace trembler
