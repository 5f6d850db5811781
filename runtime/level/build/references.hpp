// Turning names into objects once all objects exist.
#pragma once

#include "runtime/level/property/name_table.hpp"
#include "runtime/property/property_value.hpp"
#include "runtime/world/store.hpp"

#include <string>
#include <vector>

namespace trembler {

/// A reference to an object that is not there.
struct DanglingReference {
    std::string path; ///< of the field, inside its property; "" for a bare one
    std::string name;
};

/// Puts objects of `store` in the place of the names that the value refers to, and returns what could not be
/// found.
[[nodiscard]] std::vector<DanglingReference> resolveReferences(PropertyValue& value, NameTable const& names,
                                                               Store const& store);

} // namespace trembler
