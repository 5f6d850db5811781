// Values between C++ and Lua.
#pragma once

#include "lua/interaction/value.hpp"
#include "lua/sandbox/sandbox.hpp"
#include "runtime/object/object_id.hpp"
#include "runtime/property/field_place.hpp"
#include "runtime/property/field_visitor.hpp"

#include <functional>
#include <optional>

struct lua_State;

namespace trembler::lua {

/// Pushes a handle of an object, or nil for an invalid id.
using PushObject = std::function<void(lua_State*, ObjectId)>;

/// Pushes a field of the value that begins at `value`, except lists and computed fields: those need a
/// FieldPusher.
void pushField(lua_State* L, Sandbox& sandbox, FieldPlace const& place, void const* value,
               PushObject const& object);
/// Whether pushField() can push it.
[[nodiscard]] bool isPlain(FieldPlace const& place);

/// Pushes the field with one key of the visited value; nil if there is none. A list becomes a table of its
/// elements, each a value or a table of fields.
class FieldPusher final : public FieldVisitor {
public:
    FieldPusher(lua_State* L, Sandbox& sandbox, std::string_view key, PushObject const& object)
        : L_(L), sandbox_(sandbox), key_(key), object_(object) {}
    /// Whether it has pushed a field.
    [[nodiscard]] bool found() const { return found_; }

    void boolean(FieldInfo const& info, bool& value) override;
    void integer(FieldInfo const& info, std::int32_t& value) override;
    void number(FieldInfo const& info, double& value) override;
    void vector(FieldInfo const& info, Vec2& value) override;
    void text(FieldInfo const& info, std::string& value) override;
    void object(FieldInfo const& info, ObjectId& value) override;
    void choice(FieldInfo const& info, ChoiceField value) override;
    void list(FieldInfo const& info, ListField& value) override;

private:
    [[nodiscard]] bool wants(FieldInfo const& info);

    lua_State* L_;
    Sandbox& sandbox_;
    std::string_view key_;
    PushObject const& object_;
    bool found_ = false;
};

void pushValue(lua_State* L, Sandbox& sandbox, Value const& value);
/// A boolean, a number, a vector or a text; nothing for anything else.
[[nodiscard]] std::optional<Value> valueAt(lua_State* L, Sandbox const& sandbox, int index);
} // namespace trembler::lua
