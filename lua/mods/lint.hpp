// Warnings about scripts: valid code that is probably not intended.
#pragma once

#include "lua/interaction/manifest.hpp"

#include <vector>

namespace trembler::lua {

/// Names that a script declares and never mentions again: properties, whose changes wake it, parameters,
/// which players set without effect, and fields of its store. Also missing descriptions, and numbers without
/// a range. In order of lines. Names that a script puts together while it runs are not seen.
[[nodiscard]] std::vector<Diagnostic> lint(Manifest const& manifest);

} // namespace trembler::lua
