// The published JSON Schema of level files and of part definitions, made from the property descriptions.
#pragma once

#include "runtime/world/registry.hpp"

#include <nlohmann/json.hpp>

namespace trembler {

/// JSON Schema (draft 2020-12) of level files. `goals` is the schema of a condition, with its definitions
/// under "$defs": the runtime does not define goals; null allows any object. The schema cannot state that
/// names exist and that rules hold; only the program checks that.
[[nodiscard]] nlohmann::ordered_json levelSchema(Registry const& registry,
                                                 nlohmann::ordered_json const& goals);
/// JSON Schema of part definitions.
[[nodiscard]] nlohmann::ordered_json partSchema(Registry const& registry);

} // namespace trembler
