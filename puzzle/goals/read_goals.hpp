// Reads a level's "goals" and "task".
#pragma once

#include "puzzle/goals/model/condition.hpp"

namespace trembler {

/// Reads the condition under "goals"; nothing if the level has none. A condition is an object with exactly
/// one of the keys of conditionKinds(), whose value that kind reads, and optionally "for" (seconds without a
/// break), "id" and "text". Problems are added to `problems`, with their places; if there are any, the
/// condition may be incomplete, and some kinds in it may be null.
[[nodiscard]] std::optional<Condition> readGoals(LevelFile const& level, Problems& problems);
/// The same, but throws InputError if anything is wrong.
[[nodiscard]] std::optional<Condition> readGoals(LevelFile const& level);

/// The same of the condition under "task", which only a demonstration has.
[[nodiscard]] std::optional<Condition> readTask(LevelFile const& level, Problems& problems);
[[nodiscard]] std::optional<Condition> readTask(LevelFile const& level);

} // namespace trembler
