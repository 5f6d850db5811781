// Reading one property from a file by its description alone: no property is named here.
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/property/name_table.hpp"
#include "runtime/level/property/property_set.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

/// Reads the value of one property. Complains through the node and returns nothing if anything is wrong.
///
/// A property with the single field "value" is stated bare ("mass": 2); one without fields as `true`; any
/// other as an object with its fields, or as `true` if all its initial values will do. Fields in rad or rad/s
/// are stated in degrees. Fields that refer to objects state names, which go into `names`; without a table
/// (in a part definition) there is nothing to refer to, and such a field is refused.
[[nodiscard]] std::unique_ptr<PropertyValue> readProperty(PropertyInfo const& info, JsonNode const& node,
                                                          NameTable* names);

/// Reads a property into a set; `false`, where it cannot be a value, takes the property away.
void readPropertyInto(PropertySet& set, PropertyInfo const& info, JsonNode const& node, NameTable* names);

/// Reads every member of an object ("properties") whose place is `place`. Unknown keys and those that belong
/// elsewhere are complained about.
void readProperties(PropertySet& set, Registry const& registry, PropertyPlace place, JsonNode const& node,
                    NameTable* names);

/// Reads the fields of one property whose entry also has the keys `others`, for example a joint with its
/// name.
[[nodiscard]] std::unique_ptr<PropertyValue> readPropertyBeside(PropertyInfo const& info,
                                                                JsonNode const& node, NameTable* names,
                                                                std::span<std::string const> others);

/// The keys of all properties that are stated in that place.
[[nodiscard]] std::vector<std::string> keysOf(Registry const& registry, PropertyPlace place);

} // namespace trembler
