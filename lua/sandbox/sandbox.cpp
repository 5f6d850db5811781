// A sandbox's state: how it is made, and the values that it pushes for its script.
#include "lua/sandbox/sandbox.hpp"

#include "lua/sandbox/number_text.hpp"
#include "lua/sandbox/prelude/host_functions.hpp"
#include "lua/sandbox/prelude/prelude.hpp"
#include "lua/sandbox/stack_values.hpp"

#include <fmt/format.h>

#include <lua.hpp>
#include <new>
#include <stdexcept>

namespace trembler::lua {
namespace {

constexpr std::size_t trustedMemory = 4; // times as much

CountedSource const& countedPrelude() {
    static CountedSource const prelude = [] {
        std::optional<BlockFault> fault;
        return countSource(preludeText(), fault, true);
    }();
    return prelude;
}

} // namespace

Sandbox::Sandbox(ScriptLimits const& limits, Trust trust)
    : limits_(limits), trust_(trust),
      memory_(this, [](void* owner) { static_cast<Sandbox*>(owner)->noteRefusal(); }) {
    state_ = lua_newstate(Memory::allocate, &memory_);
    if (state_ == nullptr) {
        throw std::bad_alloc();
    }
    open();
}

Sandbox::~Sandbox() {
    lua_close(state_);
}

Sandbox& Sandbox::of(lua_State* L) {
    void* owner = nullptr; // the owner of the allocator: found without touching the stack
    (void)lua_getallocf(L, &owner);
    return *static_cast<Sandbox*>(static_cast<Memory*>(owner)->owner());
}

void Sandbox::openLibraries(lua_State* L) {
    for (lua_CFunction const library : {luaopen_base, luaopen_string, luaopen_math, luaopen_table}) {
        lua_pushcfunction(L, library);
        lua_pushliteral(L, "");
        lua_call(L, 1, 0);
    }
    if (!trusted()) {
        luaJIT_setmode(L, 0, LUAJIT_MODE_ENGINE | LUAJIT_MODE_OFF);
        return;
    }
    lua_pushcfunction(L, luaopen_jit); // it determines the processor for which code is made
    lua_pushliteral(L, LUA_JITLIBNAME);
    lua_call(L, 1, 0);
    lua_pushnil(L);
    lua_setglobal(L, LUA_JITLIBNAME);
    lua_pushcfunction(L, luaopen_ffi);
    lua_pushliteral(L, LUA_FFILIBNAME);
    lua_call(L, 1, 1);
    ffi_ = luaL_ref(L, LUA_REGISTRYINDEX);
    luaJIT_setmode(L, 0, LUAJIT_MODE_ENGINE | LUAJIT_MODE_ON);
}

void Sandbox::open() {
    memory_.setHost(true);
    auto const failed = run(state_, [this](lua_State* L) {
        if (trusted()) {
            lua_gc(L, LUA_GCSETPAUSE, 110); // or garbage is taken for memory that is needed
        } else {
            lua_gc(L, LUA_GCSTOP, 0);
        }
        openLibraries(L);
        compile(L, countedPrelude(), "=(prelude)");
        lua_pushvalue(L, -1);
        for (counterAt_ = 1;; ++counterAt_) {
            char const* const upvalue = lua_getupvalue(L, -1, counterAt_);
            if (upvalue == nullptr || upvalue == CountedSource::counterName) {
                break;
            }
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
        counted_ = luaL_ref(L, LUA_REGISTRYINDEX);
        setLeft(L, unlimited);
        lua_pushvalue(L, LUA_GLOBALSINDEX);
        lua_newtable(L);
        luaL_register(L, nullptr, Functions::all);
        pushString(L, joinerName);
        lua_setfield(L, -2, "joiner");
        pushString(L, CountedSource::lengthName);
        lua_setfield(L, -2, "lengthener");
        lua_call(L, 2, 13);
        inside_ = luaL_ref(L, LUA_REGISTRYINDEX);
        reading_ = luaL_ref(L, LUA_REGISTRYINDEX);
        readVectorMeta_ = luaL_ref(L, LUA_REGISTRYINDEX);
        hiddenY_ = luaL_ref(L, LUA_REGISTRYINDEX);
        hiddenX_ = luaL_ref(L, LUA_REGISTRYINDEX);
        hide_ = luaL_ref(L, LUA_REGISTRYINDEX);
        vectorMark_ = luaL_ref(L, LUA_REGISTRYINDEX);
        hostMark_ = luaL_ref(L, LUA_REGISTRYINDEX);
        fill_ = luaL_ref(L, LUA_REGISTRYINDEX);
        vectorMeta_ = luaL_ref(L, LUA_REGISTRYINDEX);
        reset_ = luaL_ref(L, LUA_REGISTRYINDEX);
        surroundings_ = luaL_ref(L, LUA_REGISTRYINDEX);
        globals_ = luaL_ref(L, LUA_REGISTRYINDEX);
        lua_pushliteral(L, "x");
        vectorX_ = luaL_ref(L, LUA_REGISTRYINDEX);
        lua_pushliteral(L, "y");
        vectorY_ = luaL_ref(L, LUA_REGISTRYINDEX);
    });
    if (failed) {
        lua_close(state_);
        throwKept();
        throw std::runtime_error(fmt::format("a Lua state could not be made: {}", failed->message));
    }
    memory_.setCap(mostMemory());
}

std::size_t Sandbox::mostMemory() const {
    return trusted() ? trustedMemory * limits_.memory : limits_.memory;
}

void Sandbox::pushChunk(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, chunk_);
}
void Sandbox::pushFfi(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, ffi_);
}
void Sandbox::pushSurroundings(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, surroundings_);
}
void Sandbox::showChunk(lua_State* L, std::string_view name) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, globals_);
    pushString(L, name);
    lua_pushvalue(L, -3);
    lua_rawset(L, -3);
    lua_pop(L, 2);
}
void Sandbox::pushVectorMeta(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, vectorMeta_);
}
void Sandbox::pushVectorMark(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, vectorMark_);
}
void Sandbox::pushHostMark(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, hostMark_);
}
void Sandbox::pushVectorKeyX(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, source_.assignsFields ? hiddenX_ : vectorX_);
}
void Sandbox::pushVectorKeyY(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, source_.assignsFields ? hiddenY_ : vectorY_);
}
void Sandbox::pushVector(lua_State* L, double x, double y) const {
    lua_createtable(L, 0, 2);
    pushVectorKeyX(L);
    lua_pushnumber(L, x);
    lua_rawset(L, -3);
    pushVectorKeyY(L);
    lua_pushnumber(L, y);
    lua_rawset(L, -3);
    pushVectorMeta(L);
    lua_setmetatable(L, -2);
}

void Sandbox::pushReadVector(lua_State* L, double x, double y) const {
    pushVector(L, x, y);
    if (source_.assignsFields) {
        lua_rawgeti(L, LUA_REGISTRYINDEX, readVectorMeta_);
        lua_setmetatable(L, -2);
    }
}

void Sandbox::pushReadingMeta(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, reading_);
}
void Sandbox::pushReadingMark(lua_State* L) const {
    pushReadingMeta(L);
    lua_getfield(L, -1, "__metatable");
    lua_replace(L, -2);
}
void Sandbox::closeReading(lua_State* L) const {
    luaL_checkstack(L, 4, "tables in tables");
    if (source_.assignsFields) {
        lua_createtable(L, 0, 1);
        lua_rawgeti(L, LUA_REGISTRYINDEX, inside_);
        lua_pushvalue(L, -4);
        lua_rawset(L, -3);
        lua_replace(L, -3);
    }
    lua_setmetatable(L, -2);
}
void Sandbox::pushInside(lua_State* L, int index) const {
    if (!source_.assignsFields) {
        lua_pushvalue(L, index);
        return;
    }
    lua_rawgeti(L, LUA_REGISTRYINDEX, inside_);
    lua_rawget(L, index);
}

void Sandbox::pushText(lua_State* L, std::string_view text) {
    if (text.size() > longestString) {
        raise(L, fmt::format("a text of {} bytes; expected at most {}", text.size(), longestString));
    }
    charge(L, 5 + static_cast<double>(text.size()) / 8);
    if (readsAsLongNumber(text)) {
        pushString(L, fmt::format("({})", text));
    } else {
        pushString(L, text);
    }
}

std::optional<Vec2> Sandbox::vectorAt(lua_State* L, int index) const {
    if (lua_type(L, index) != LUA_TTABLE) {
        return std::nullopt;
    }
    int const table = index < 0 ? lua_gettop(L) + 1 + index : index;
    auto const at = [&](void (Sandbox::*pushKey)(lua_State*) const, int plainKey) {
        (this->*pushKey)(L);
        lua_rawget(L, table);
        if (lua_isnil(L, -1) && source_.assignsFields) { // no vector, but a table with such fields
            lua_pop(L, 1);
            lua_rawgeti(L, LUA_REGISTRYINDEX, plainKey);
            lua_rawget(L, table);
        }
        auto const number =
            lua_type(L, -1) == LUA_TNUMBER ? std::optional(lua_tonumber(L, -1)) : std::nullopt;
        lua_pop(L, 1);
        return number;
    };
    auto const x = at(&Sandbox::pushVectorKeyX, vectorX_);
    auto const y = at(&Sandbox::pushVectorKeyY, vectorY_);
    return x && y ? std::optional(Vec2{*x, *y}) : std::nullopt;
}

} // namespace trembler::lua
