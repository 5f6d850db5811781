// The rules for liquids in a level.
#pragma once

#include "runtime/world/registry.hpp"

#include <vector>

namespace trembler {

/// A liquid needs a shape, which is its area. Its pieces must not overlap each other or other liquids, as an
/// object in an overlap would be lifted twice. Returns the faults with the expected conditions, ascending by
/// object: for each liquid its first own piece that overlaps another, else the first liquid before it that it
/// overlaps. O(n log n) for n pieces if the bounding boxes of pieces that do not overlap meet only a few
/// others. See ObjectRule.
[[nodiscard]] std::vector<ObjectFault> checkLiquids(Store const& store);

} // namespace trembler
