// The greatest limits that scripts may state. Only the player can raise them.
#pragma once

#include "lua/sandbox/limits.hpp"

namespace trembler::lua {

/// ScriptLimits::greatest(), unless allowLimits() has said otherwise. Thread-safe.
[[nodiscard]] ScriptLimits allowedLimits();
/// Applies to all manifests that are read from now on in this process. Thread-safe.
void allowLimits(ScriptLimits const& limits);

} // namespace trembler::lua
