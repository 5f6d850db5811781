// The properties that a file states for one object or one part.
#pragma once

#include "runtime/property/property_value.hpp"

#include <memory>
#include <span>
#include <vector>

namespace trembler {

/// Values by property, in order of their keys. Copying copies the values.
class PropertySet {
public:
    struct Entry {
        PropertyInfo const* info;
        /// Null: the object does not have the property, even if its part states it ("fixed": false).
        std::unique_ptr<PropertyValue> value;
    };

    PropertySet() = default;
    PropertySet(PropertySet const& other);
    PropertySet& operator=(PropertySet const& other);
    PropertySet(PropertySet&&) noexcept = default;
    PropertySet& operator=(PropertySet&&) noexcept = default;
    ~PropertySet() = default;

    /// Adds or replaces a value.
    void set(std::unique_ptr<PropertyValue> value);
    template <ObjectProperty P>
    void set(P value) {
        set(std::make_unique<ValueOf<P>>(std::move(value)));
    }
    /// States that the object does not have the property, even if its part states it.
    void takeAway(PropertyInfo const& info);
    /// Removes the entry of the property.
    void erase(PropertyInfo const& info);

    /// Whether anything is stated about the property.
    [[nodiscard]] bool states(PropertyInfo const& info) const { return entry(info) != nullptr; }
    /// The stated value, or nullptr.
    [[nodiscard]] PropertyValue const* find(PropertyInfo const& info) const;
    [[nodiscard]] PropertyValue* find(PropertyInfo const& info);
    template <ObjectProperty P>
    [[nodiscard]] P const* find() const {
        auto const* const value = static_cast<ValueOf<P> const*>(find(propertyInfo<P>()));
        return value == nullptr ? nullptr : &value->value;
    }
    [[nodiscard]] std::span<Entry const> entries() const { return entries_; }
    [[nodiscard]] bool empty() const { return entries_.empty(); }

private:
    [[nodiscard]] Entry const* entry(PropertyInfo const& info) const;
    Entry& place(PropertyInfo const& info);

    std::vector<Entry> entries_;
};

} // namespace trembler
