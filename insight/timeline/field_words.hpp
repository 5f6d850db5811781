// Properties of any type as words, by the fields that they describe.
#pragma once

#include "insight/timeline/words.hpp"
#include "runtime/property/field_visitor.hpp"

namespace trembler::insight {

/// Writes every visited field.
class FieldWriter final : public FieldVisitor {
public:
    explicit FieldWriter(Words& words) : out_(words) {}

    void boolean(FieldInfo const&, bool& value) override { out_.members(value); }
    void integer(FieldInfo const&, std::int32_t& value) override { out_.members(value); }
    void number(FieldInfo const&, double& value) override { out_.members(value); }
    void vector(FieldInfo const&, Vec2& value) override { out_.members(value); }
    void text(FieldInfo const&, std::string& value) override { out_.members(value); }
    void object(FieldInfo const&, ObjectId& value) override { out_.members(value); }
    void choice(FieldInfo const&, ChoiceField field) override { out_.members(field.index); }
    void list(FieldInfo const&, ListField& list) override {
        out_.word(list.size());
        for (std::size_t i = 0; i < list.size(); ++i) {
            list.visitElement(i, *this);
        }
    }

private:
    WordWriter out_;
};

/// Sets every visited field to what FieldWriter wrote. A field that is present for some choices only follows
/// its choice, so the same fields are visited.
class FieldReader final : public FieldVisitor {
public:
    explicit FieldReader(WordReader& words) : in_(words) {}

    void boolean(FieldInfo const&, bool& value) override { in_.members(value); }
    void integer(FieldInfo const&, std::int32_t& value) override { in_.members(value); }
    void number(FieldInfo const&, double& value) override { in_.members(value); }
    void vector(FieldInfo const&, Vec2& value) override { in_.members(value); }
    void text(FieldInfo const&, std::string& value) override { in_.members(value); }
    void object(FieldInfo const&, ObjectId& value) override { in_.members(value); }
    void choice(FieldInfo const&, ChoiceField field) override { in_.members(field.index); }
    void list(FieldInfo const&, ListField& list) override {
        list.resize(static_cast<std::size_t>(in_.word()));
        for (std::size_t i = 0; i < list.size(); ++i) {
            list.visitElement(i, *this);
        }
    }

private:
    WordReader& in_;
};

} // namespace trembler::insight
