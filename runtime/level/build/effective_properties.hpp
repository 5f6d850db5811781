// Combines the properties of an object's part and of its own entry.
#pragma once

#include "runtime/level/property/property_set.hpp"

#include <string>
#include <vector>

namespace trembler {

/// The part's properties, replaced by those that the entry states, without those that the entry removes.
[[nodiscard]] PropertySet effectiveProperties(PropertySet const& part, PropertySet const& own);
/// The keys of the properties that an object is stated not to have, by its entry or, if the entry does not
/// state them, by its part; ascending.
[[nodiscard]] std::vector<std::string> statedAbsent(PropertySet const& part, PropertySet const& own);

} // namespace trembler
