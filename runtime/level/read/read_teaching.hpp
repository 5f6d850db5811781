// "teaching" of a level: the steps of a beginner's first lesson.
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/model/teaching_step.hpp"

#include <vector>

namespace trembler {

/// Reads [{"place": PART, "at", "angle_deg", "flipped"} | {"wire": [A, B]} | {"run": true} |
/// {"grab": OBJECT, "to"} | {"cut": [A, B]}, ...]. Whether the names exist is checked with the whole level.
[[nodiscard]] std::vector<TeachingStep> readTeaching(JsonNode const& node);
/// The inverse.
[[nodiscard]] nlohmann::ordered_json writeTeaching(std::vector<TeachingStep> const& steps);
/// The JSON Schema of it.
[[nodiscard]] nlohmann::ordered_json teachingSchema();

} // namespace trembler
