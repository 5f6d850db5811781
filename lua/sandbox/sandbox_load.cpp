// Loading a script into a sandbox: its text is checked, counted, compiled and given its globals.
#include "lua/sandbox/number_text.hpp"
#include "lua/sandbox/prelude/host_functions.hpp"
#include "lua/sandbox/sandbox.hpp"
#include "lua/sandbox/source/source_check.hpp"

#include <fmt/format.h>

#include <lua.hpp>
#include <utility>

namespace trembler::lua {

std::optional<ScriptError> Sandbox::load(std::string_view text, std::string const& name,
                                         VectorArguments const* vectors) {
    if (auto const fault = faultInSource(text)) {
        std::string const place = fault->line == 0 ? name : fmt::format("{}:{}", name, fault->line);
        return ScriptError{fmt::format("{}: {}", place, fault->message), {}, false};
    }
    std::optional<BlockFault> fault;
    source_ = countSource(withCountedJoins(text), fault, false, vectors);
    // LuaJIT's message is better: it quotes the text at the place. If LuaJIT finds no error, the blocks are
    // wrong.
    auto failed = protect([&](lua_State* L) {
        if (fault) {
            if (luaL_loadbuffer(L, text.data(), text.size(), ("@" + name).c_str()) == 0) {
                lua_pushstring(L, fmt::format("{}:{}: {}", name, fault->line, fault->message).c_str());
            }
            lua_error(L);
        }
        if (luaL_loadbuffer(L, source_.text.data(), source_.text.size(), ("@" + name).c_str()) != 0) {
            if (luaL_loadbuffer(L, text.data(), text.size(), ("@" + name).c_str()) == 0) {
                lua_pop(L, 1);
            }
            lua_error(L); // LuaJIT's message quotes the script, and not the text with the counters if that is
                          // possible
        }
        lua_pushcfunction(L, guarded<Functions::over>);
        lua_call(L, 1, 1);
        bindCounter(L);
        if (source_.assignsFields) {
            lua_rawgeti(L, LUA_REGISTRYINDEX, hide_);
            lua_call(L, 0, 0);
        }
        chooseGlobals(L);
        lua_rawgeti(L, LUA_REGISTRYINDEX, globals_);
        lua_setfenv(L, -2);
        chunk_ = luaL_ref(L, LUA_REGISTRYINDEX);
    });
    collect();
    return failed;
}

void Sandbox::compile(lua_State* L, CountedSource const& source, std::string const& name) {
    if (luaL_loadbuffer(L, source.text.data(), source.text.size(), name.c_str()) != 0) {
        lua_error(L);
    }
    lua_pushcfunction(L, guarded<Functions::over>);
    lua_call(L, 1, 1);
}

// The function on top of the stack counts down the same variable as the prelude.
void Sandbox::bindCounter(lua_State* L) const {
    for (int i = 1;; ++i) {
        char const* const upvalue = lua_getupvalue(L, -1, i);
        if (upvalue == nullptr) {
            return; // it has nothing to count
        }
        lua_pop(L, 1);
        if (upvalue == CountedSource::counterName) {
            lua_rawgeti(L, LUA_REGISTRYINDEX, counted_);
            lua_upvaluejoin(L, -2, i, -1, counterAt_);
            lua_pop(L, 1);
            return;
        }
    }
}

void Sandbox::chooseGlobals(lua_State* L) {
    plainGlobals_ = true;
    lua_rawgeti(L, LUA_REGISTRYINDEX, surroundings_);
    for (std::string const& name : source_.assigned) {
        lua_pushlstring(L, name.data(), name.size());
        lua_rawget(L, -2);
        // The functions that the host adds later count as well.
        plainGlobals_ =
            plainGlobals_ && lua_isnil(L, -1) && name != "world" && name != "alive" && name != "same";
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
}

void Sandbox::rehearse(lua_State* L, int times) {
    double const before = left(L);
    auto const log = std::exchange(onLog, nullptr);
    for (int i = 0; i < times; ++i) {
        pushChunk(L);
        callScript(L, 0, 0);
        setLeft(L, before);
    }
    onLog = log;
}

} // namespace trembler::lua
