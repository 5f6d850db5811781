// The JSON Schema of properties, made from their descriptions.
#pragma once

#include "runtime/property/property_info.hpp"
#include "runtime/world/registry.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace trembler {

/// The schema of one property's value in files: an object with its fields, or the short form if it has one;
/// false removes the property.
[[nodiscard]] nlohmann::ordered_json propertySchema(PropertyInfo const& info);
/// The schema of an object that holds all fields of a property as its members, without the short forms.
[[nodiscard]] nlohmann::ordered_json fieldsSchema(PropertyInfo const& info);
/// The schema of an object whose members are the properties stated in `place`, except "name".
[[nodiscard]] nlohmann::ordered_json propertiesSchema(Registry const& registry, PropertyPlace place);
/// The meaning of a field, with its unit in files.
[[nodiscard]] std::string describedField(FieldInfo const& info);

} // namespace trembler
