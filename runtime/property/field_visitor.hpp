// Access to the fields of a property whose type is not known at compile time, for files, inspector and
// scripts.
#pragma once

#include "runtime/property/description.hpp"

namespace trembler {

class FieldVisitor;

/// A list inside a property, with its element type hidden.
class ListField {
public:
    virtual ~ListField() = default;
    [[nodiscard]] virtual std::size_t size() const = 0;
    virtual void resize(std::size_t count) = 0;
    /// True if an element is a struct with fields of its own, false if it is one bare value.
    [[nodiscard]] virtual bool elementsHaveFields() const = 0;
    /// Visits the fields of one element; a bare value is visited as a single field with key "value", and the
    /// unit, meaning and range that the list's description gives.
    virtual void visitElement(std::size_t index, FieldVisitor& visitor) = 0;
};

/// A value out of a fixed set of names.
struct ChoiceField {
    int& index;
    std::span<std::string_view const> names;
};

/// Receives every field of a property by reference, in the order of its description, and may change it.
class FieldVisitor {
public:
    virtual ~FieldVisitor() = default;
    virtual void boolean(FieldInfo const&, bool&) = 0;
    virtual void integer(FieldInfo const&, std::int32_t&) = 0;
    virtual void number(FieldInfo const&, double&) = 0;
    virtual void vector(FieldInfo const&, Vec2&) = 0;
    virtual void text(FieldInfo const&, std::string&) = 0;
    virtual void object(FieldInfo const&, ObjectId&) = 0;
    virtual void choice(FieldInfo const&, ChoiceField) = 0;
    virtual void list(FieldInfo const&, ListField&) = 0;
};

namespace detail {

template <class T>
void dispatch(FieldVisitor& visitor, FieldInfo const& info, T& value);

template <class T>
class VectorField final : public ListField {
public:
    VectorField(std::vector<T>& values, FieldInfo const& info) : values_(values), info_(info) {}
    [[nodiscard]] std::size_t size() const override { return values_.size(); }
    void resize(std::size_t count) override { values_.resize(count); }
    [[nodiscard]] bool elementsHaveFields() const override { return Described<T>; }
    void visitElement(std::size_t index, FieldVisitor& visitor) override {
        if constexpr (Described<T>) {
            T::describe(values_[index],
                        [&](FieldInfo const& info, auto& field) { dispatch(visitor, info, field); });
        } else {
            FieldInfo element = info_;
            element.key = "value";
            element.required = false;
            dispatch(visitor, element, values_[index]);
        }
    }

private:
    std::vector<T>& values_;
    FieldInfo const& info_;
};

template <class T>
inline constexpr bool isVector = false;
template <class T>
inline constexpr bool isVector<std::vector<T>> = true;

template <class T>
void dispatch(FieldVisitor& visitor, FieldInfo const& info, T& value) {
    if constexpr (std::is_same_v<T, bool>) {
        visitor.boolean(info, value);
    } else if constexpr (std::is_same_v<T, std::int32_t>) {
        visitor.integer(info, value);
    } else if constexpr (std::is_same_v<T, double>) {
        visitor.number(info, value);
    } else if constexpr (std::is_same_v<T, Vec2>) {
        visitor.vector(info, value);
    } else if constexpr (std::is_same_v<T, std::string>) {
        visitor.text(info, value);
    } else if constexpr (std::is_same_v<T, ObjectId>) {
        visitor.object(info, value);
    } else if constexpr (std::is_enum_v<T>) {
        static_assert(!choiceNames<T>.empty(), "specialise trembler::choiceNames for this enumeration");
        int index = static_cast<int>(value);
        visitor.choice(info, {index, choiceNames<T>});
        value = static_cast<T>(index);
    } else {
        static_assert(isVector<T>, "the type of a field must be bool, int32, double, Vec2, string, ObjectId, "
                                   "an enumeration, or a vector of these or of structs with describe()");
        VectorField<typename T::value_type> list(value, info);
        visitor.list(info, list);
    }
}

} // namespace detail

/// Visits every field of `property`; a property without describe() has none.
template <class P>
void visitFields([[maybe_unused]] P& property, [[maybe_unused]] FieldVisitor& visitor) {
    if constexpr (Described<P>) {
        P::describe(property,
                    [&](FieldInfo const& info, auto& field) { detail::dispatch(visitor, info, field); });
    } else {
        static_assert(MayLackFields<P>, "an object property with members that level files may state must "
                                        "describe them: 'static void describe(Self&, Visitor&&)'");
    }
}

} // namespace trembler
