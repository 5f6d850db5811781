// Every function of Lua that scripts have takes all arguments that it has in Lua, the optional ones among
// them, and gives the same: each call is made in a sandbox and in a plain state of LuaJIT.
#include "lua/sandbox/prelude/signatures.hpp"
#include "lua/sandbox/sandbox.hpp"
#include "lua/sandbox/stack_values.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <lua.hpp>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace trembler::lua {
namespace {

struct LuaCall {
    std::string_view function;
    std::string_view arguments;
    std::string_view chunk = "return $"; ///< in which the call is $
};

// By the reference of Lua 5.1 and LuaJIT's extensions: how many arguments a function has; those with any
// number have -1.
std::map<std::string_view, int> const& argumentsInLua() {
    static std::map<std::string_view, int> const most{
        {"assert", -1},
        {"coroutine.create", 1},
        {"coroutine.resume", -1},
        {"coroutine.status", 1},
        {"coroutine.wrap", 1},
        {"coroutine.yield", -1},
        {"error", 2},
        {"getmetatable", 1},
        {"ipairs", 1},
        {"math.abs", 1},
        {"math.atan", 1},
        {"math.atan2", 2},
        {"math.ceil", 1},
        {"math.cos", 1},
        {"math.deg", 1},
        {"math.exp", 1},
        {"math.floor", 1},
        {"math.fmod", 2},
        {"math.log", 2},
        {"math.max", -1},
        {"math.min", -1},
        {"math.rad", 1},
        {"math.sin", 1},
        {"math.sqrt", 1},
        {"math.tan", 1},
        {"next", 2},
        {"pairs", 1},
        {"pcall", -1},
        {"print", -1},
        {"select", -1},
        {"setmetatable", 2},
        {"string.byte", 3},
        {"string.char", -1},
        {"string.find", 4},
        {"string.format", -1},
        {"string.len", 1},
        {"string.lower", 1},
        {"string.rep", 3},
        {"string.reverse", 1},
        {"string.sub", 3},
        {"string.upper", 1},
        {"table.concat", 4},
        {"table.insert", 3},
        {"table.remove", 2},
        {"table.sort", 2},
        {"tonumber", 2},
        {"tostring", 1},
        {"type", 1},
        {"unpack", 3},
        {"xpcall", -1},
    };
    return most;
}

// Functions that only scripts have.
std::set<std::string_view> const& notInLua() {
    static std::set<std::string_view> const names{
        "interaction", "log",        "vec2",         "vec2:length", "vec2:dot", "vec2:cross",  "vec2:unit",
        "vec2:turned", "math.clamp", "table.unpack", "alive",       "same",     "frame.random"};
    return names;
}

std::vector<LuaCall> const& luaCalls() {
    static std::vector<LuaCall> const all{
        {"assert", "1, 'message', 3"},
        {"assert", "false, 'message', 3", "return pcall(function() $ end)"},
        {"coroutine.create", "function(a) return a end", "return type($)"},
        {"coroutine.resume", "coroutine.create(function(...) return select('#', ...), ... end), 1, nil, 3"},
        {"coroutine.status", "coroutine.create(function() end)"},
        {"coroutine.wrap", "function(...) return ... end", "return $(1, nil, 'x')"},
        {"coroutine.yield", "1, nil, 3",
         "local f = coroutine.wrap(function() return 'in', $ end)\nlocal a, b, c = f()\nreturn a, b, c, f(7, "
         "8)"},
        {"error", "'m', 0", "return pcall(function() $ end)"},
        {"error", "'m', 1", "return pcall(function()\n$ end)"},
        {"error", "'m', 2", "local function f()\n$\nend\nreturn pcall(function()\nf()\nend)"},
        {"error", "nil, 2", "return pcall(function() $ end)"},
        {"error", "{}, 2", "local good, caught = pcall(function() $ end) return good, type(caught)"},
        {"getmetatable", "setmetatable({}, { __metatable = 'mine' })"},
        {"ipairs", "{ 5, 6 }", "local s = 0 for i, v in $ do s = s + i * v end return s"},
        {"math.abs", "-2.5"},
        {"math.atan", "0.5"},
        {"math.atan2", "-1, -2"},
        {"math.ceil", "-1.5"},
        {"math.cos", "1"},
        {"math.deg", "1"},
        {"math.exp", "2"},
        {"math.floor", "-1.5"},
        {"math.fmod", "-7, 3"},
        {"math.log", "10"},
        {"math.log", "8, 2"},
        {"math.log", "1000, 10"},
        {"math.max", "1, 3, 2"},
        {"math.min", "3, 1, 2"},
        {"math.rad", "90"},
        {"math.sin", "1"},
        {"math.sqrt", "2"},
        {"math.tan", "1"},
        {"next", "{ 5, 6 }, 1"},
        {"next", "{ 5, 6 }, 2"},
        {"next", "{ 5 }, nil"},
        {"pairs", "{ 5, 6 }", "local s = 0 for i, v in $ do s = s + i * v end return s"},
        {"pcall", "function(...) return select('#', ...), ... end, 1, nil, 3"},
        {"pcall", "error, 'm', 0"},
        {"print", "1, nil, 'x', true", "return type(print)"}, // what it prints goes elsewhere
        {"select", "2, 'a', 'b', nil"},
        {"select", "-1, 'a', 'b'"},
        {"select", "'#', nil, nil"},
        {"setmetatable", "{}, { __index = { x = 3 } }", "return $.x"},
        {"setmetatable", "{}, nil", "return type($)"},
        {"string.byte", "'lamp', 2, 4"},
        {"string.byte", "'lamp', -3, -2"},
        {"string.byte", "'lamp', 3"},
        {"string.byte", "'lamp', 3, 1", "return select('#', $)"},
        {"string.byte", "'lamp', 1, 100"},
        {"string.byte", "'lamp', -100, 2"},
        {"string.char", "104, 105, 33"},
        {"string.find", "'a.b.c', '.', 3, true"},
        {"string.find", "'a.b.c', '.', -1, true"},
        {"string.find", "'a.b.c', '.c', -2, true"},
        {"string.find", "'a[b', '[', 1, true"},
        {"string.find", "'a%b', '%', nil, true"},
        {"string.find", "'lamp', 'm', 1, false"},
        {"string.find", "'lamp', 'a)', 1, nil"},
        {"string.find", "'lamp', '', 10, true"},
        {"string.find", "'lamp', 'm', 1, 1"},
        {"string.format",
         "'%5.2f|%d|%i|%u|%o|%x|%X|%c|%e|%E|%g|%G|%q|%s|%10s|%-5d|%+d|%%|%05d', 3.14159, 42, -7, 9, 8, 255, "
         "255, 65, 12345.678, 12345.678, 1e20, 1e-10, 'a \"b\"\\n', true, 'right', 3, 4, 5"},
        {"string.format", "'%a %A %.3s', 1, 0.5, 'lamps'"},
        {"string.len", "'lamp'"},
        {"string.lower", "'LAMP'"},
        {"string.rep", "'ab', 3, '-'"},
        {"string.rep", "'ab', 1, '-'"},
        {"string.rep", "'ab', 0, '-'"},
        {"string.rep", "'ab', -1, '-'"},
        {"string.rep", "'', 3, ', '"},
        {"string.rep", "'ab', 3"},
        {"string.reverse", "'lamp'"},
        {"string.sub", "'lamp 1', 2, -3"},
        {"string.sub", "'lamp 1', -1"},
        {"string.sub", "'lamp 1', 0, 100"},
        {"string.upper", "'lamp'"},
        {"table.concat", "{ 'a', 2, 'c', 'd' }, ', ', 2, 3"},
        {"table.concat", "{ 'a', 2, 'c' }, ', ', 2"},
        {"table.concat", "{ 'a', 2, 'c' }, nil, 3, 3"},
        {"table.concat", "{ 'a', 2, 'c' }, ', ', 3, 2"},
        {"table.concat", "{ 'a', 2 }, '-'"},
        {"table.concat", "{ [5] = 'x', [6] = 'y' }, '+', 5, 6"},
        {"table.insert", "t, 2, 'x'", "local t = { 1, 2, 3 } $ return unpack(t)"},
        {"table.insert", "t, 'x'", "local t = { 1, 2, 3 } $ return unpack(t)"},
        {"table.remove", "t, 1", "local t = { 1, 2, 3 } local r = $ return r, unpack(t)"},
        {"table.sort", "t, function(a, b) return a > b end", "local t = { 1, 3, 2 } $ return unpack(t)"},
        {"tonumber", "'ff', 16"},
        {"tonumber", "'zz', 36"},
        {"tonumber", "'12', 2"},
        {"tonumber", "10, 8"},
        {"tonumber", "' 0x10 '"},
        {"tonumber", "'lamp'"},
        {"tonumber", "true"},
        {"tostring", "12.5"},
        {"type", "nil"},
        {"unpack", "{ 1, 2, 3, 4 }, 2, 3"},
        {"unpack", "{ 1, 2 }, 1, 4", "return select('#', $)"},
        {"unpack", "{ 1, 2, 3 }, 2"},
        {"xpcall", "function(...) return select('#', ...), ... end, print, 1, nil, 3"},
        {"xpcall", "error, function(m) return 'caught ' .. m end, 'm', 0"},
    };
    return all;
}

std::string chunkOf(LuaCall const& call) {
    std::string chunk(call.chunk);
    if (std::size_t const at = chunk.find('$'); at != std::string::npos) {
        chunk.replace(at, 1, fmt::format("{}({})", call.function, call.arguments));
    }
    return chunk;
}

std::string valuesOnStack(lua_State* L, int first) {
    std::string all;
    for (int i = first; i <= lua_gettop(L); ++i) {
        all += fmt::format("{} ", luaL_typename(L, i));
        if (lua_type(L, i) == LUA_TNUMBER) {
            all += fmt::format("{:.14g}", lua_tonumber(L, i));
        } else if (lua_type(L, i) == LUA_TSTRING) {
            all += textAt(L, i);
        } else if (lua_type(L, i) == LUA_TBOOLEAN) {
            all += lua_toboolean(L, i) != 0 ? "true" : "false";
        }
        all += "; ";
    }
    return all;
}

std::string inPlainLua(std::string const& chunk) {
    std::unique_ptr<lua_State, void (*)(lua_State*)> const state(luaL_newstate(), lua_close);
    lua_State* const L = state.get();
    luaL_openlibs(L);
    bool const good = luaL_loadbuffer(L, chunk.data(), chunk.size(), "@call.lua") == 0 &&
                      lua_pcall(L, 0, LUA_MULTRET, 0) == 0;
    return good ? valuesOnStack(L, 1) : "error: " + textAt(L, -1);
}

std::string inSandbox(std::string const& chunk, Trust trust) {
    Sandbox sandbox(ScriptLimits{}, trust);
    sandbox.onLog = [](std::string const&) {};
    if (auto const refused = sandbox.load(chunk, "call.lua")) {
        return "error: " + refused->message;
    }
    std::string values;
    auto const failed = sandbox.turn(1, [&](lua_State* L) {
        int const before = lua_gettop(L);
        sandbox.pushChunk(L);
        sandbox.callScript(L, 0, LUA_MULTRET);
        values = valuesOnStack(L, before + 1);
    });
    return failed ? "error: " + failed->message : values;
}

TEST(OptionalArguments, GiveWhatTheyGiveInLua) {
    for (LuaCall const& call : luaCalls()) {
        std::string const chunk = chunkOf(call);
        SCOPED_TRACE(chunk);
        std::string const expected = inPlainLua(chunk);
        for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
            EXPECT_EQ(inSandbox(chunk, trust), expected);
        }
    }
}

TEST(OptionalArguments, AreAllOfEachFunctionAndEachIsTried) {
    std::map<std::string_view, int> tried;
    for (LuaCall const& call : luaCalls()) {
        // A name that the chunk declares is nil here, and counts all the same.
        std::string const count = inPlainLua(fmt::format("return select('#', {})", call.arguments));
        ASSERT_TRUE(count.starts_with("number ")) << count;
        tried[call.function] = std::max(tried[call.function], std::stoi(count.substr(7)));
    }
    for (HostFunction const& function : hostFunctions()) {
        SCOPED_TRACE(function.name);
        auto const most = argumentsInLua().find(function.name);
        if (most == argumentsInLua().end()) {
            EXPECT_TRUE(notInLua().contains(function.name));
            continue;
        }
        auto const parameters = static_cast<int>(function.parameters.size());
        EXPECT_EQ(function.more, most->second == -1);
        if (most->second == -1) {
            EXPECT_GT(tried[function.name], parameters);
        } else {
            EXPECT_EQ(parameters, most->second);
            EXPECT_EQ(tried[function.name], parameters);
        }
    }
}

// Patterns are not there, and are not taken for words where a script asks for one.
TEST(OptionalArguments, OfFindRefuseAPattern) {
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        std::string const said = inSandbox("local at = ('a.b'):find('.', 1, false)", trust);
        EXPECT_NE(said.find("call.lua:1: there are no patterns"), std::string::npos) << said;
        EXPECT_EQ(inSandbox("return ('a.b'):find('.')", trust), "number 2; number 2; ");
    }
}

// A number that is no whole one of 32 bits would be converted differently on other processors.
TEST(OptionalArguments, BeyondAllPlacesAreTheNearestPlace) {
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        EXPECT_EQ(inSandbox("return ('lamp'):sub(2, math.huge), ('lamp'):sub(-1e300, 2)", trust),
                  "string amp; string la; ");
        EXPECT_EQ(inSandbox("return ('lamp'):byte(-math.huge, 1e20)", trust),
                  "number 108; number 97; number 109; number 112; ");
        EXPECT_EQ(inSandbox("return ('lamp'):find('m', 1e20, true)", trust), "nil ; ");
    }
}

} // namespace
} // namespace trembler::lua
