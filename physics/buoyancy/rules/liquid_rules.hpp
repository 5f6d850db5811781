// The rules for liquids in a level.
#pragma once

#include "runtime/world/registry.hpp"

#include <vector>

namespace trembler {

/// A liquid needs a shape, its area; its pieces must not overlap each other or other liquids, as an object in
/// an overlap would be lifted twice. Returns the faults with the expected conditions, ascending by object:
/// for each liquid its first own piece that overlaps another, else the first liquid before it that it
/// overlaps. In n log n of all pieces, if boxes along the axes around pieces that do not overlap meet only a
/// few others. See ObjectRule.
[[nodiscard]] std::vector<ObjectFault> checkLiquids(Store const& store);

} // namespace trembler
