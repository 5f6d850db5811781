// The scripts of an object, for the inspector.
#pragma once

#include "game/ui/panels/inspector.hpp"
#include "lua/attach/live_script.hpp"
#include "lua/attach/scripts_property.hpp"

#include <vector>

namespace trembler::ui {

/// A row for each script with its description, and one for each of its parameters with the value that applies
/// to the object. For a script that `known` lacks, or without `known`, only the object's own statements.
[[nodiscard]] std::vector<InspectorRow> scriptRows(lua::Scripts const& scripts,
                                                   lua::LiveScripts const* known);

} // namespace trembler::ui
