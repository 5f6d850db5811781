// A base for visitors that handle some kinds of fields only.
#pragma once

#include "runtime/property/field_visitor.hpp"

namespace trembler {

/// Leaves every field as it is, and does not look into lists. Override the functions for the kinds of fields
/// that matter.
class IdleVisitor : public FieldVisitor {
public:
    void boolean(FieldInfo const&, bool&) override {}
    void integer(FieldInfo const&, std::int32_t&) override {}
    void number(FieldInfo const&, double&) override {}
    void vector(FieldInfo const&, Vec2&) override {}
    void text(FieldInfo const&, std::string&) override {}
    void object(FieldInfo const&, ObjectId&) override {}
    void choice(FieldInfo const&, ChoiceField) override {}
    void list(FieldInfo const&, ListField&) override {}
};

} // namespace trembler
