// Reads "changes" of a recorded solution.
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/model/recorded_change.hpp"

#include <vector>

namespace trembler {

/// A list of entries {"frame", and one of "detail", "period", "setting"}; each of these may change several
/// things:
///     {"frame": 61, "detail": {"gravity": "tree"}}
///     {"frame": 61, "period": {"Buoyancy Resolver": 4}}
///     {"frame": 61, "setting": {"gravity_law": {"opening_angle": 0.5}}}
/// Complains about what has not that form. Whether there are such effects, components and properties is known
/// only where there is a registry. Ascending by frame; those of one frame keep the order of the file.
[[nodiscard]] std::vector<RecordedChange> readChanges(JsonNode const& node);

} // namespace trembler
