// Reading a level's "goals".
#pragma once

#include "puzzle/goals/condition.hpp"

namespace trembler {

/// Reads the condition under "goals"; nothing if the level has none. A condition is an object with exactly
/// one of the keys
///
///     "inside":   {"object": O, "area": [x, y, width, height] or [[x, y], ...], "called": "the basket"}
///     "touching": [O, O]
///     "on": O     "off": O
///     "moved":    {"object": O, "by": metres, "towards": "up" | "down" | "left" | "right"}
///     "count":    {"of": O, "at_least" | "at_most" | "exactly": n, "that": condition on "it"}
///     "all": [conditions]     "any": [conditions]     "sequence": [conditions]     "not": condition
///
/// and, where wanted, "for" (seconds without a break), "id" and "text". O is the name of an object, {"part":
/// name} for anything made from that part, or a list of these. Problems go to `problems`, with their places.
[[nodiscard]] std::optional<Condition> readGoals(LevelFile const& level, Problems& problems);
/// The same, but throws InputError if anything is wrong.
[[nodiscard]] std::optional<Condition> readGoals(LevelFile const& level);

} // namespace trembler
