// The run-time face of a property type.
#pragma once

#include "runtime/property/description.hpp"
#include "runtime/property/field_visitor.hpp"

#include <memory>
#include <typeindex>

namespace trembler {

class ColumnBase;
class SlotBase;
class PropertyValue;

/// Everything that is known of a property type without naming it. One constant instance per type; compare
/// by `type`, order by `text.key`.
struct PropertyInfo {
    std::type_index type;
    PropertyKind kind;
    PropertyText text;
    std::unique_ptr<ColumnBase> (*makeColumn)();   ///< object properties only
    std::unique_ptr<SlotBase> (*makeSlot)();       ///< resolver and derived properties only
    std::unique_ptr<PropertyValue> (*makeValue)(); ///< object properties only: a value outside any column
};

template <ObjectProperty P>
class Column;
template <ObjectProperty P>
class ValueOf;
template <Property P>
class Slot;

/// The information of P, made on first use. Thread-safe.
template <Property P>
[[nodiscard]] PropertyInfo const& propertyInfo() {
    static PropertyInfo const info = [] {
        PropertyInfo made{typeid(P), P::kind, P::text, nullptr, nullptr, nullptr};
        if constexpr (ObjectProperty<P>) {
            made.makeColumn = []() -> std::unique_ptr<ColumnBase> { return std::make_unique<Column<P>>(); };
            made.makeValue = []() -> std::unique_ptr<PropertyValue> {
                return std::make_unique<ValueOf<P>>();
            };
        } else {
            made.makeSlot = []() -> std::unique_ptr<SlotBase> { return std::make_unique<Slot<P>>(); };
        }
        return made;
    }();
    return info;
}

} // namespace trembler
