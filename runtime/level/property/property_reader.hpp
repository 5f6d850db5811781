// Reads a property from a file by its description alone: no property is named here.
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/property/name_table.hpp"
#include "runtime/level/property/property_set.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

/// Reads the value of one property. Complains through the node and returns nothing if anything is wrong.
///
/// A property with the single field "value" is stated as that value ("mass": 2), called bare; one without
/// fields as `true`; any other as an object with its fields, or as `true` for the initial values of all
/// fields. Fields in rad or rad/s are stated in degrees. Fields that refer to objects state names, which are
/// added to `names`; without a table (in a part definition) such fields are refused.
[[nodiscard]] std::unique_ptr<PropertyValue> readProperty(PropertyInfo const& info, JsonNode const& node,
                                                          NameTable* names);

/// Reads a property into a set; `false`, unless it is a valid value, removes the property.
void readPropertyInto(PropertySet& set, PropertyInfo const& info, JsonNode const& node, NameTable* names);

/// Reads every member of an object ("properties") whose place is `place`. Complains about unknown keys and
/// keys that belong in another place.
void readProperties(PropertySet& set, Registry const& registry, PropertyPlace place, JsonNode const& node,
                    NameTable* names);

/// Reads the fields of a property from an entry that also has the keys `others`, for example a joint with its
/// name.
[[nodiscard]] std::unique_ptr<PropertyValue> readPropertyBeside(PropertyInfo const& info,
                                                                JsonNode const& node, NameTable* names,
                                                                std::span<std::string const> others);

/// The keys of all properties that are stated in that place.
[[nodiscard]] std::vector<std::string> keysOf(Registry const& registry, PropertyPlace place);

} // namespace trembler
