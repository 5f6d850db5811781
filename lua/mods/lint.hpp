// Warnings about scripts: valid code that is probably not intended.
#pragma once

#include "lua/interaction/manifest.hpp"

#include <vector>

namespace trembler::lua {

/// Things that a script declares and never mentions again: properties, which wake it when they change,
/// parameters, which players set without effect, and fields of its store; and numbers for players without
/// words. In order of lines. Names that a script puts together while it runs are not seen.
[[nodiscard]] std::vector<Diagnostic> lint(Manifest const& manifest);

} // namespace trembler::lua
