// Reads "changes" of a recorded solution.
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/model/recorded_change.hpp"

#include <vector>

namespace trembler {

/// Reads a list of entries {"frame", and one of "detail", "period", "setting"}; an entry may make several
/// changes:
///     {"frame": 61, "detail": {"gravity": "tree"}}
///     {"frame": 61, "period": {"Buoyancy Resolver": 4}}
///     {"frame": 61, "setting": {"gravity_law": {"opening_angle": 0.5}}}
/// Complains about entries of another form. Does not check that the effects, components and properties exist,
/// as that needs a registry. Ascending by frame; changes of one frame keep the order of the file.
[[nodiscard]] std::vector<RecordedChange> readChanges(JsonNode const& node);

} // namespace trembler
