// Reads a manifest out of the table that a script returns.
#pragma once

#include "lua/interaction/manifest.hpp"

#include <nlohmann/json_fwd.hpp>

namespace trembler::lua {

/// Fills a manifest, which has its file and its source already, with the values that the script has returned
/// (see treeOf()). Adds all errors to `problems`.
void readInto(Manifest& manifest, nlohmann::json const& all, Problems& problems);

} // namespace trembler::lua
