// Random commands of the editor, for property tests and for the fuzzer.
#pragma once

#include "puzzle/edit/document/level_document.hpp"

#include <functional>

namespace trembler::edit {

/// A command out of all kinds, as the numbers say, which `next` gives: 0 to its argument, exclusive. Throws
/// CommandError for one that is not possible here.
[[nodiscard]] Command anyCommand(LevelDocument const& document, std::function<int(int)> const& next);

} // namespace trembler::edit
