// Values on the stack of a Lua state, in the host's own types and words.
#include "lua/sandbox/stack_values.hpp"

#include "lua/sandbox/sandbox.hpp"

#include <algorithm>
#include <lua.hpp>

namespace trembler::lua {

std::string textAt(lua_State* L, int index) {
    std::size_t size = 0;
    char const* const text = lua_type(L, index) == LUA_TSTRING ? lua_tolstring(L, index, &size) : nullptr;
    return text == nullptr ? std::string() : std::string(text, size);
}

void pushString(lua_State* L, std::string_view text) {
    lua_pushlstring(L, text.data(), text.size());
}

std::vector<std::string> stringKeys(lua_State* L, int index) {
    std::vector<std::string> keys;
    int const table = index < 0 ? lua_gettop(L) + 1 + index : index;
    lua_pushnil(L);
    while (lua_next(L, table) != 0) {
        if (lua_type(L, -2) == LUA_TSTRING) {
            keys.push_back(textAt(L, -2));
        }
        lua_pop(L, 1);
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

std::string kindOf(lua_State* L, int index) {
    switch (lua_type(L, index)) {
    case LUA_TNONE:
    case LUA_TNIL:
        return "nil";
    case LUA_TTABLE: {
        int const table = index < 0 ? lua_gettop(L) + 1 + index : index;
        bool vector = false;
        if (lua_getmetatable(L, table) != 0) {
            Sandbox::of(L).pushVectorMeta(L);
            vector = lua_rawequal(L, -1, -2) != 0;
            lua_pop(L, 2);
        }
        return vector ? "vector" : "table";
    }
    case LUA_TUSERDATA:
        return "object";
    default:
        return lua_typename(L, lua_type(L, index));
    }
}

} // namespace trembler::lua
