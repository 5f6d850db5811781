// Random commands of the editor, for property tests and for the fuzzer.
#pragma once

#include "puzzle/edit/document/level_document.hpp"

#include <functional>

namespace trembler::edit {

/// A random command of any kind. `next` gives the numbers that determine it: from 0 to its argument,
/// exclusive. Throws CommandError for a command that is not possible here.
[[nodiscard]] Command anyCommand(LevelDocument const& document, std::function<int(int)> const& next);

} // namespace trembler::edit
