// What a level must not say of liquids.
#pragma once

#include "runtime/world/store.hpp"

#include <optional>

namespace trembler {

/// A liquid needs a shape, its area; its pieces, and two liquids, must not overlap, as what is in both would
/// be lifted twice. Returns what is wrong and what was expected, in words, or nothing. See ObjectRule.
[[nodiscard]] std::optional<std::string> checkLiquid(Store const& store, ObjectId id);

} // namespace trembler
