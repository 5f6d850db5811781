// Writes properties as files state them: the inverse of property_reader.hpp.
#pragma once

#include "runtime/level/property/name_table.hpp"
#include "runtime/level/property/property_set.hpp"
#include "runtime/world/registry.hpp"

#include <nlohmann/json.hpp>

namespace trembler {

/// The JSON that readProperty() reads back as the same value. Fields that have their initial value are left
/// out, except required ones. Numbers are written so that they read back bit for bit; references to objects
/// as their names in the table.
[[nodiscard]] nlohmann::ordered_json writeProperty(PropertyValue const& value, NameTable const& names = {});

/// An object with one member per property whose place is `place`; removed properties are `false`.
[[nodiscard]] nlohmann::ordered_json writeProperties(PropertySet const& set, PropertyPlace place,
                                                     NameTable const& names = {});

} // namespace trembler
