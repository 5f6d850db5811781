// Reads recorded solutions of a level file: placements, inputs and changes.
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/model/level.hpp"

namespace trembler {

/// Reads the list at "solutions". Names of objects are checked later, when all of the level is known.
[[nodiscard]] std::vector<Solution> readSolutions(JsonNode const& node);
/// Reads a list of {"part", "at", "angle_deg"}, for example from a separate file.
[[nodiscard]] std::vector<Placement> readPlacements(JsonNode const& node);
/// Reads one solution from a separate file.
[[nodiscard]] std::optional<Solution> readSolution(JsonNode const& node);

} // namespace trembler
