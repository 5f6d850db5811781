// Replaces names by objects once all objects exist.
#pragma once

#include "runtime/level/property/name_table.hpp"
#include "runtime/property/property_value.hpp"
#include "runtime/world/store.hpp"

#include <string>
#include <vector>

namespace trembler {

/// A reference to a missing object.
struct DanglingReference {
    std::string path; ///< of the field, inside its property; "" for a bare one
    std::string name;
};

/// Replaces the names in the value by objects of `store`, and returns the references that were not found. The
/// objects' names begin with `prefix`, which is not part of the names in the value: those of a part's pieces.
[[nodiscard]] std::vector<DanglingReference> resolveReferences(PropertyValue& value, NameTable const& names,
                                                               Store const& store,
                                                               std::string const& prefix = {});

} // namespace trembler
