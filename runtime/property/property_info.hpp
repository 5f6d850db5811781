// The description of a property type at run time.
#pragma once

#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"
#include "runtime/property/field_place.hpp"
#include "runtime/property/field_visitor.hpp"

#include <memory>
#include <typeindex>

namespace trembler {

class ColumnBase;
class SlotBase;
class PropertyValue;

/// All information about a property type that code can use without naming the type. One constant instance per
/// type; compare by `type`, order by `text.key`.
struct PropertyInfo {
    std::type_index type;
    PropertyKind kind;
    PropertyText text;
    std::unique_ptr<ColumnBase> (*makeColumn)();   ///< object properties only
    std::unique_ptr<SlotBase> (*makeSlot)();       ///< resolver and derived properties only
    std::unique_ptr<PropertyValue> (*makeValue)(); ///< object properties only: a value outside any column
    Coverage coverage{};                           ///< by the state hash
    std::size_t size = 0;                          ///< of a value, in bytes
    std::vector<FieldPlace> (*fields)() = nullptr; ///< where its fields lie; nullptr: it describes none
};

/// How the state hash covers a property. Object properties are hashed, unless one that no component reads
/// states why it is left out; derived properties follow from the properties that their derived property set
/// reads (5.5); a resolver property states its coverage.
template <Property P>
[[nodiscard]] constexpr Coverage coverageOf() {
    if constexpr (P::kind == PropertyKind::object && LeftOutOfHash<P>) {
        return P::coverage;
    } else if constexpr (P::kind == PropertyKind::object) {
        return hashed;
    } else if constexpr (P::kind == PropertyKind::derived) {
        return derivedFrom("a pure function of the properties that its derived property set reads (5.5)");
    } else {
        constexpr bool states = requires {
            { P::coverage } -> std::convertible_to<Coverage>;
        };
        static_assert(states, "a resolver property must declare how the state hash covers it: 'static "
                              "constexpr Coverage coverage = hashed', derivedFrom(what) or leftOut(why)");
        if constexpr (states) {
            return P::coverage;
        } else {
            return {};
        }
    }
}

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
        PropertyInfo made{typeid(P), P::kind, P::text, nullptr, nullptr, nullptr, coverageOf<P>()};
        made.size = sizeof(P);
        if constexpr (Described<P>) {
            made.fields = [] { return fieldPlaces<P>(); };
        }
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
