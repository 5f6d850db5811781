// The numbers of a running world that can be read by name, found in the descriptions of the properties.
#pragma once

#include "runtime/level/property/field_outline.hpp"
#include "runtime/world/registry.hpp"

#include <string>
#include <vector>

namespace trembler::watch {

/// A field that can be watched. It belongs to a property of an object; to a resolver property or derived
/// property as a whole, which counts as the world's; or to the entry that such a property has for an object.
/// An entry is an element of a list whose first field refers to an object.
struct WatchedField {
    PropertyInfo const* property = nullptr;
    std::string list; ///< key of the list of entries; empty: a field of the property itself
    std::string key;  ///< of the field; "value" if the property is a single value
    FieldType type = FieldType::number;
    std::string unit;  ///< as displayed: degrees for angles; empty for a pure number
    bool adds = false; ///< entries of the same object are summed; otherwise the first one counts

    /// Whether it belongs to the world as a whole: to a resolver property or derived property, outside its
    /// entries.
    [[nodiscard]] bool ofWorld() const { return property->kind != PropertyKind::object && list.empty(); }
    /// The full name: "magnetic_force.force", or the property's key alone if that is a single value.
    [[nodiscard]] std::string name() const;
    /// The same with the property's display name in lower case and with underscores: "position", "f_m.force".
    [[nodiscard]] std::string spokenName() const;
    /// Whether a word is one of the two full names.
    [[nodiscard]] bool isNamed(std::string_view word) const { return word == name() || word == spokenName(); }
    /// Whether a word is the field's key alone ("current"), which several properties may share.
    [[nodiscard]] bool isKnownAs(std::string_view word) const { return key == word && key != "value"; }
};

/// All fields that the registry's properties have, in order of the properties' keys.
[[nodiscard]] std::vector<WatchedField> watchedFields(Registry const& registry);

} // namespace trembler::watch
