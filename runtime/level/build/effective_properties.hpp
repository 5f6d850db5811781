// What an object gets from its part and what from its own entry.
#pragma once

#include "runtime/level/property/property_set.hpp"

#include <string>
#include <vector>

namespace trembler {

/// The part's properties, replaced by those that the entry states itself, without those that it takes away.
[[nodiscard]] PropertySet effectiveProperties(PropertySet const& part, PropertySet const& own);
/// The keys of the properties that an object is stated not to have, by its entry or, where that says nothing
/// of them, by its part; ascending.
[[nodiscard]] std::vector<std::string> statedAbsent(PropertySet const& part, PropertySet const& own);

} // namespace trembler
