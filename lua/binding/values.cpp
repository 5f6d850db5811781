#include "lua/binding/values.hpp"

#include <algorithm>
#include <cstring>
#include <lua.hpp>

namespace trembler::lua {
namespace {

// Building a list costs the script about as many instructions as reading it does.
constexpr double chargePerElement = 10;

template <class T>
T const& at(void const* value, FieldPlace const& place) {
    return *reinterpret_cast<T const*>(static_cast<char const*>(value) + place.offset); // NOLINT
}

void pushName(lua_State* L, std::span<std::string_view const> names, int index) {
    if (index >= 0 && index < static_cast<int>(names.size())) {
        std::string_view const name = names[static_cast<std::size_t>(index)];
        lua_pushlstring(L, name.data(), name.size());
    } else {
        lua_pushnil(L);
    }
}

/// Adds every field to the table on top of the stack.
class TableFiller final : public FieldVisitor {
public:
    TableFiller(lua_State* L, Sandbox& sandbox, PushObject const& object)
        : L_(L), sandbox_(sandbox), object_(object) {}
    void boolean(FieldInfo const& info, bool& value) override { add(info, value); }
    void integer(FieldInfo const& info, std::int32_t& value) override { add(info, value); }
    void number(FieldInfo const& info, double& value) override { add(info, value); }
    void vector(FieldInfo const& info, Vec2& value) override { add(info, value); }
    void text(FieldInfo const& info, std::string& value) override { add(info, value); }
    void object(FieldInfo const& info, ObjectId& value) override { add(info, value); }
    void choice(FieldInfo const& info, ChoiceField value) override { add(info, value); }
    void list(FieldInfo const& info, ListField& value) override { add(info, value); }

private:
    template <class T>
    void add(FieldInfo const& info, T& value) {
        luaL_checkstack(L_, 10, "lists in lists");
        lua_pushlstring(L_, info.key.data(), info.key.size());
        FieldPusher pusher(L_, sandbox_, info.key, object_);
        visit(pusher, info, value);
        lua_rawset(L_, -3);
    }
    static void visit(FieldPusher& to, FieldInfo const& info, bool& value) { to.boolean(info, value); }
    static void visit(FieldPusher& to, FieldInfo const& info, std::int32_t& value) {
        to.integer(info, value);
    }
    static void visit(FieldPusher& to, FieldInfo const& info, double& value) { to.number(info, value); }
    static void visit(FieldPusher& to, FieldInfo const& info, Vec2& value) { to.vector(info, value); }
    static void visit(FieldPusher& to, FieldInfo const& info, std::string& value) { to.text(info, value); }
    static void visit(FieldPusher& to, FieldInfo const& info, ObjectId& value) { to.object(info, value); }
    static void visit(FieldPusher& to, FieldInfo const& info, ChoiceField& value) { to.choice(info, value); }
    static void visit(FieldPusher& to, FieldInfo const& info, ListField& value) { to.list(info, value); }

    lua_State* L_;
    Sandbox& sandbox_;
    PushObject const& object_;
};

} // namespace

bool isPlain(FieldPlace const& place) {
    return place.offset != FieldPlace::nowhere && place.kind != FieldKind::list;
}

void pushField(lua_State* L, Sandbox& sandbox, FieldPlace const& place, void const* value,
               PushObject const& object) {
    switch (place.kind) {
    case FieldKind::boolean:
        lua_pushboolean(L, at<bool>(value, place) ? 1 : 0);
        return;
    case FieldKind::integer:
        lua_pushnumber(L, at<std::int32_t>(value, place));
        return;
    case FieldKind::number:
        lua_pushnumber(L, at<double>(value, place));
        return;
    case FieldKind::vector: {
        Vec2 const& vector = at<Vec2>(value, place);
        sandbox.pushReadVector(L, vector.x, vector.y);
        return;
    }
    case FieldKind::text: {
        sandbox.pushText(L, at<std::string>(value, place));
        return;
    }
    case FieldKind::object:
        object(L, at<ObjectId>(value, place));
        return;
    case FieldKind::choice: {
        int index = 0; // its first bytes are the lowest: little-endian
        std::memcpy(&index, static_cast<char const*>(value) + place.offset,
                    std::min(place.size, sizeof index));
        pushName(L, place.choices, index);
        return;
    }
    default:
        lua_pushnil(L);
        return;
    }
}

bool FieldPusher::wants(FieldInfo const& info) {
    if (found_ || info.key != key_) {
        return false;
    }
    found_ = true;
    return true;
}
void FieldPusher::boolean(FieldInfo const& info, bool& value) {
    if (wants(info)) {
        lua_pushboolean(L_, value ? 1 : 0);
    }
}
void FieldPusher::integer(FieldInfo const& info, std::int32_t& value) {
    if (wants(info)) {
        lua_pushnumber(L_, value);
    }
}
void FieldPusher::number(FieldInfo const& info, double& value) {
    if (wants(info)) {
        lua_pushnumber(L_, value);
    }
}
void FieldPusher::vector(FieldInfo const& info, Vec2& value) {
    if (wants(info)) {
        sandbox_.pushReadVector(L_, value.x, value.y);
    }
}
void FieldPusher::text(FieldInfo const& info, std::string& value) {
    if (wants(info)) {
        sandbox_.pushText(L_, value);
    }
}
void FieldPusher::object(FieldInfo const& info, ObjectId& value) {
    if (wants(info)) {
        object_(L_, value);
    }
}
void FieldPusher::choice(FieldInfo const& info, ChoiceField value) {
    if (wants(info)) {
        pushName(L_, value.names, value.index);
    }
}
void FieldPusher::list(FieldInfo const& info, ListField& value) {
    if (!wants(info)) {
        return;
    }
    luaL_checkstack(L_, 10, "lists in lists");
    lua_createtable(L_, static_cast<int>(std::min<std::size_t>(value.size(), 100'000)), 0);
    for (std::size_t i = 0; i < value.size(); ++i) {
        sandbox_.charge(L_, chargePerElement);
        if (value.elementsHaveFields()) {
            lua_newtable(L_);
            TableFiller filler(L_, sandbox_, object_);
            value.visitElement(i, filler);
            sandbox_.pushReadingMeta(L_);
            sandbox_.closeReading(L_);
        } else {
            FieldPusher element(L_, sandbox_, "value", object_);
            value.visitElement(i, element);
            if (!element.found()) {
                lua_pushnil(L_);
            }
        }
        lua_rawseti(L_, -2, static_cast<int>(i) + 1);
    }
    sandbox_.pushReadingMeta(L_);
    sandbox_.closeReading(L_);
}

void pushValue(lua_State* L, Sandbox& sandbox, Value const& value) {
    if (bool const* const truth = std::get_if<bool>(&value)) {
        lua_pushboolean(L, *truth ? 1 : 0);
    } else if (double const* const number = std::get_if<double>(&value)) {
        lua_pushnumber(L, *number);
    } else if (Vec2 const* const vector = std::get_if<Vec2>(&value)) {
        sandbox.pushReadVector(L, vector->x, vector->y);
    } else {
        sandbox.pushText(L, std::get<std::string>(value));
    }
}

std::optional<Value> valueAt(lua_State* L, Sandbox const& sandbox, int index) {
    switch (lua_type(L, index)) {
    case LUA_TBOOLEAN:
        return Value(lua_toboolean(L, index) != 0);
    case LUA_TNUMBER:
        return Value(lua_tonumber(L, index));
    case LUA_TSTRING: {
        std::size_t size = 0;
        char const* const text = lua_tolstring(L, index, &size);
        return Value(std::string(text, size));
    }
    default:
        if (auto const vector = sandbox.vectorAt(L, index)) {
            return Value(*vector);
        }
        return std::nullopt;
    }
}

} // namespace trembler::lua
