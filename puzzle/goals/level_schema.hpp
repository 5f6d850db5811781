// The JSON Schema of level files, goals included: what `trembler schema` prints and levels/level.schema.json
// holds.
#pragma once

#include "runtime/world/registry.hpp"

#include <nlohmann/json.hpp>

namespace trembler {

/// A schema whose "$defs" hold "condition" and what it needs. Refers to the definitions "name" and "area" of
/// the level's schema.
[[nodiscard]] nlohmann::ordered_json goalSchema();

/// The whole schema of a level file.
[[nodiscard]] nlohmann::ordered_json levelSchema(Registry const& registry);

} // namespace trembler
