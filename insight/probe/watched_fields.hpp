// The numbers of a running world that can be read by name, found in the descriptions of the properties.
#pragma once

#include "runtime/level/property/field_outline.hpp"
#include "runtime/world/registry.hpp"

#include <string>
#include <vector>

namespace trembler::watch {

/// A list on the way from a property to one of its fields, and the elements of it that are read.
struct ListStep {
    std::string key;
    bool ofObject = false;   ///< the elements that belong to one object, otherwise the one at `element`
    std::size_t element = 0; ///< its number, from 0

    friend bool operator==(ListStep const&, ListStep const&) = default;
};

/// A field that can be watched. It belongs to a property of an object; to a resolver property or derived
/// property as a whole, which counts as the world's; or to the entry that such a property has for an object.
/// An entry is an element of a list whose first field has the key "object". Fields of other elements, and of
/// entries as well, are reached by the element's number; a list itself is read as its number of elements.
struct WatchedField {
    PropertyInfo const* property = nullptr;
    std::vector<ListStep> lists; ///< outermost first; empty: a field of the property itself
    std::string key;             ///< of the field; "value" if a property or an element is a single value
    FieldType type = FieldType::number; ///< list: the number of its elements
    std::string unit;                   ///< as displayed: degrees for angles; empty for a pure number
    bool adds = false;                  ///< entries of the same object are summed, otherwise the first counts
    int component = -1; ///< of a vector: 0 for x, 1 for y, 2 for its length; -1: both, in two columns

    /// Whether it is a field of the entry for an object.
    [[nodiscard]] bool ofEntry() const { return !lists.empty() && lists.front().ofObject; }
    /// Whether its name contains the number of an element.
    [[nodiscard]] bool numbered() const { return lists.size() > (ofEntry() ? 1U : 0U); }
    /// Whether it belongs to the world as a whole: to a resolver property or derived property, outside the
    /// entries for objects.
    [[nodiscard]] bool ofWorld() const { return property->kind != PropertyKind::object && !ofEntry(); }
    /// The full name: "magnetic_force.force", "shape.0.width", "contacts.current.count", or the property's
    /// key alone if that is a single value. Without the component.
    [[nodiscard]] std::string name() const;
    /// The same with the property's display name in lower case and with underscores: "position", "f_m.force".
    [[nodiscard]] std::string spokenName() const;
    /// Whether a word is one of the two full names.
    [[nodiscard]] bool isNamed(std::string_view word) const { return word == name() || word == spokenName(); }
    /// Whether a word is the field's key alone ("current"), which several properties may share.
    [[nodiscard]] bool isKnownAs(std::string_view word) const {
        return key == word && key != "value" && type != FieldType::list && !numbered();
    }
};

/// All fields that the registry's properties describe, in order of the properties' keys. Of each list the
/// element 0 stands for all; fields that an element has for some of its choices only are included.
[[nodiscard]] std::vector<WatchedField> watchedFields(Registry const& registry);

} // namespace trembler::watch
