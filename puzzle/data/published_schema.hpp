// The JSON Schema of level files that is published beside the levels.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace trembler {

/// levels/level.schema.json: of every effect, with what levels may state about scripts. Which scripts there
/// are depends on the mods, so the schema knows no names of theirs.
[[nodiscard]] nlohmann::ordered_json publishedSchema();

} // namespace trembler
