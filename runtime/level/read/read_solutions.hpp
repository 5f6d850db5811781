// Reading the parts of a level file that tell what a player did: placements and timed inputs.
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/model/level.hpp"

namespace trembler {

/// Reads the list at "solutions". Names of objects are checked later, when all of the level is known.
[[nodiscard]] std::vector<Solution> readSolutions(JsonNode const& node);
/// Reads a list of {"part", "at", "angle_deg"}, for example from a file of its own.
[[nodiscard]] std::vector<Placement> readPlacements(JsonNode const& node);
/// Reads one solution as it stands in a file of its own.
[[nodiscard]] std::optional<Solution> readSolution(JsonNode const& node);

} // namespace trembler
