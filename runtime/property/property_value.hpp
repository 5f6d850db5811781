// A value of some property, outside any column: part definitions and level entries consist of these.
#pragma once

#include "runtime/property/column.hpp"

namespace trembler {

class PropertyValue {
public:
    virtual ~PropertyValue() = default;
    [[nodiscard]] virtual PropertyInfo const& info() const = 0;
    [[nodiscard]] virtual std::unique_ptr<PropertyValue> clone() const = 0;
    virtual void visit(FieldVisitor& visitor) = 0;
    /// Gives `id` this value in `column`, which must be of the same property.
    virtual void assignTo(ColumnBase& column, ObjectId id) const = 0;
};

template <ObjectProperty P>
class ValueOf final : public PropertyValue {
public:
    ValueOf() = default;
    explicit ValueOf(P initial) : value(std::move(initial)) {}
    [[nodiscard]] PropertyInfo const& info() const override { return propertyInfo<P>(); }
    [[nodiscard]] std::unique_ptr<PropertyValue> clone() const override {
        return std::make_unique<ValueOf>(value);
    }
    void visit(FieldVisitor& visitor) override { visitFields(value, visitor); }
    void assignTo(ColumnBase& column, ObjectId id) const override {
        assert(column.info().type == info().type);
        static_cast<Column<P>&>(column).set(id, value);
    }

    P value;
};

} // namespace trembler
