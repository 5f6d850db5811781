// The other half of the random commands.
#pragma once

#include "puzzle/edit/document/level_document.hpp"

#include <functional>

namespace trembler::edit {

/// One of the commands that anyCommand() does not make itself, on lists inside of properties, connections,
/// goals, recorded solutions and the level as a whole. Throws CommandError if it is refused.
[[nodiscard]] Command anyFurtherCommand(LevelDocument const& document, std::function<int(int)> const& next);

} // namespace trembler::edit
