// Which numbers of a running world can be asked for by name: found out from the descriptions of properties.
#pragma once

#include "runtime/level/property/field_outline.hpp"
#include "runtime/world/registry.hpp"

#include <string>
#include <vector>

namespace trembler::watch {

/// One field that can be watched: of a property of objects; of a resolver or derived property as a whole,
/// which belongs to the world; or of the entry that such a property has for an object. An entry is an element
/// of a list whose first field names an object.
struct WatchedField {
    PropertyInfo const* property = nullptr;
    std::string list; ///< key of the list of entries; empty: a field of the property itself
    std::string key;  ///< of the field; "value" if the property is bare
    FieldType type = FieldType::number;
    std::string unit;  ///< as shown: degrees for angles; empty for a pure number
    bool adds = false; ///< several entries of one object add up; otherwise the first counts

    /// Whether it is a number or a vector of the world as a whole: of a resolver or derived property without
    /// entries.
    [[nodiscard]] bool ofWorld() const { return property->kind != PropertyKind::object && list.empty(); }
    /// "magnetic_force.force", or the property's key alone where that is bare: how it is written out.
    [[nodiscard]] std::string name() const;
    /// The same with the property's own name, in small letters and with low lines: "position", "f_m.force".
    [[nodiscard]] std::string spokenName() const;
    /// Whether a word means it: one of the two names ...
    [[nodiscard]] bool isNamed(std::string_view word) const { return word == name() || word == spokenName(); }
    /// ... or the field's key alone ("current"), which several may share.
    [[nodiscard]] bool isKnownAs(std::string_view word) const { return key == word && key != "value"; }
};

/// All that there is in a program, in order of the properties' keys.
[[nodiscard]] std::vector<WatchedField> watchedFields(Registry const& registry);

} // namespace trembler::watch
