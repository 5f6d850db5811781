// A Lua value as a JSON tree, which is easier to look through than the stack of a Lua state.
#include "lua/interaction/lua_tree.hpp"

#include "lua/sandbox/sandbox.hpp"
#include "lua/sandbox/stack_values.hpp"

#include <nlohmann/json.hpp>

#include <lua.hpp>
#include <string>

namespace trembler::lua {

using nlohmann::json;

namespace {

constexpr int deepest = 6; // tables in tables
constexpr char const* vectorKey = "$vector";
constexpr char const* functionKey = "$function";

} // namespace

json treeOf(lua_State* L, int index, int depth) {
    // A table that is in several others is read several times, which could take for ever if it were not
    // charged for.
    constexpr double chargePerValue = 5;
    Sandbox::of(L).charge(L, chargePerValue);
    switch (lua_type(L, index)) {
    case LUA_TBOOLEAN:
        return lua_toboolean(L, index) != 0;
    case LUA_TNUMBER:
        return lua_tonumber(L, index);
    case LUA_TSTRING: {
        std::size_t size = 0;
        char const* const text = lua_tolstring(L, index, &size);
        return std::string(text, size);
    }
    case LUA_TFUNCTION:
        return json{{functionKey, true}};
    case LUA_TTABLE:
        break;
    default:
        return nullptr;
    }
    if (depth >= deepest) {
        return nullptr;
    }
    luaL_checkstack(L, 10, "tables in tables");
    if (kindOf(L, index) == "vector") {
        Vec2 const vector = Sandbox::of(L).vectorAt(L, index).value_or(Vec2{});
        return json{{vectorKey, {vector.x, vector.y}}};
    }
    json list = json::array();
    json fields = json::object();
    lua_pushnil(L);
    while (lua_next(L, index) != 0) {
        if (lua_type(L, -2) == LUA_TSTRING) {
            std::size_t size = 0;
            char const* const key = lua_tolstring(L, -2, &size);
            fields[std::string(key, size)] = treeOf(L, lua_gettop(L), depth + 1);
        } else {
            list.push_back(nullptr);
        }
        lua_pop(L, 1);
    }
    for (std::size_t i = 0; i < list.size(); ++i) { // lua_next has no order
        lua_rawgeti(L, index, static_cast<int>(i) + 1);
        list[i] = treeOf(L, lua_gettop(L), depth + 1);
        lua_pop(L, 1);
    }
    return fields.empty() ? list : fields;
}

bool isFunction(json const& value) {
    return value.is_object() && value.contains(functionKey);
}

std::optional<Value> valueOf(json const& value) {
    if (value.is_boolean()) {
        return value.get<bool>();
    }
    if (value.is_number()) {
        return value.get<double>();
    }
    if (value.is_string()) {
        return value.get<std::string>();
    }
    if (value.is_object() && value.contains(vectorKey)) {
        return Vec2{value[vectorKey][0].get<double>(), value[vectorKey][1].get<double>()};
    }
    return std::nullopt;
}

} // namespace trembler::lua
