// A level as a player meets it: in the player's language, and a demonstration with its task.
#pragma once

#include "runtime/level/model/level.hpp"

#include <string>

namespace trembler {

/// Texts in the language as far as the level has them. A demonstration with a "task" becomes a level whose
/// goals are the task: goals that it reaches by itself are no success of the player's. Names of objects, and
/// so recordings, stay the same.
[[nodiscard]] LevelFile asPlayed(LevelFile level, std::string const& language);

} // namespace trembler
