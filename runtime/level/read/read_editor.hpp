// The level editor's own data in a level file. No simulation reads them.
#pragma once

#include "runtime/level/json/json_node.hpp"

namespace trembler {

/// Checks the form of {"groups": [[name, ...], ...], "locked": [name, ...], "hidden": [name, ...]}, complains
/// about all else, and returns the value as it is. Whether there are objects of these names is not checked: a
/// file from which an object was deleted by hand stays a valid level.
[[nodiscard]] nlohmann::json readEditor(JsonNode const& node);

} // namespace trembler
