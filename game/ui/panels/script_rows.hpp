// The scripts of an object, for the inspector.
#pragma once

#include "game/ui/panels/inspector.hpp"
#include "lua/attach/live_script.hpp"
#include "lua/attach/scripts_property.hpp"

#include <vector>

namespace trembler::ui {

/// A row for each script with what it does, and one for each of its parameters with the value that counts for
/// the object. Of a script that `known` has not, or without `known`, only what the object states.
[[nodiscard]] std::vector<InspectorRow> scriptRows(lua::Scripts const& scripts,
                                                   lua::LiveScripts const* known);

} // namespace trembler::ui
