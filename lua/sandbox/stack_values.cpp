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
        if (lua_getmetatable(L, index) == 0) {
            return "table";
        }
        Sandbox const& sandbox = Sandbox::of(L);
        std::string kind = "table";
        sandbox.pushVectorMark(L); // also of vectors that were read, which have a metatable of their own
        lua_pushliteral(L, "__metatable");
        lua_rawget(L, -3);
        sandbox.pushHostMark(L);
        if (lua_rawequal(L, -2, -3) != 0) {
            kind = "vector";
        } else if (lua_rawequal(L, -1, -2) != 0) {
            lua_pushliteral(L, "__name");
            lua_rawget(L, -5);
            kind = lua_type(L, -1) == LUA_TSTRING ? textAt(L, -1) : kind;
            lua_pop(L, 1);
        }
        lua_pop(L, 4);
        return kind;
    }
    case LUA_TUSERDATA:
        return "object";
    case LUA_TTHREAD:
        return "coroutine";
    default:
        return lua_typename(L, lua_type(L, index));
    }
}

std::string kindInWords(lua_State* L, int index) {
    std::string kind = kindOf(L, index);
    if (kind == "nil") {
        return kind;
    }
    if (kind == "world") {
        return "the world";
    }
    if (kind == "object") {
        return "an object";
    }
    bool const named = kind == "params" || kind == "out" || kind == "store" || kind == "frame";
    return named ? "'" + kind + "'" : "a " + kind;
}

std::string numberText(lua_State* L, double number) {
    lua_pushnumber(L, number);
    std::size_t size = 0;
    char const* const text = lua_tolstring(L, -1, &size);
    std::string copy(text, size);
    lua_pop(L, 1);
    return copy;
}

std::string shownText(lua_State* L, int index) {
    switch (lua_type(L, index)) {
    case LUA_TSTRING:
        return textAt(L, index);
    case LUA_TNUMBER:
        return numberText(L, lua_tonumber(L, index));
    case LUA_TBOOLEAN:
        return lua_toboolean(L, index) != 0 ? "true" : "false";
    default:
        break;
    }
    std::string kind = kindOf(L, index);
    if (kind == "vector") {
        if (auto const vector = Sandbox::of(L).vectorAt(L, index)) {
            return "(" + numberText(L, vector->x) + ", " + numberText(L, vector->y) + ")";
        }
    }
    return kind;
}

} // namespace trembler::lua
