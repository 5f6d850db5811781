// The rules for liquids in a level.
#pragma once

#include "runtime/world/registry.hpp"

#include <vector>

namespace trembler {

/// A liquid needs a shape, its area; its pieces, and two liquids, must not overlap, as an object in both
/// would be lifted twice. Returns the faults with what was expected, ascending by object: of each liquid the
/// first of its own pieces that overlap, else the first of the liquids before it. In n log n of all pieces,
/// if boxes along the axes around pieces that do not overlap meet only a few others. See ObjectRule.
[[nodiscard]] std::vector<ObjectFault> checkLiquids(Store const& store);

} // namespace trembler
