// The functions of the host that Lua calls: the arguments of the prelude, and the functions by which the
// sandbox runs a script in protected mode.
#include "lua/sandbox/prelude/host_functions.hpp"

#include "lua/sandbox/exact_math.hpp"
#include "lua/sandbox/stack_values.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace trembler::lua {
namespace {

// Comparing a word with all known ones takes as long as this many instructions.
constexpr double chargePerSuggestion = 3000;

double angleAt(lua_State* L) {
    double const angle = luaL_checknumber(L, 1);
    if (!(std::abs(angle) <= largestAngle)) {
        Sandbox::of(L).raise(L, fmt::format("an angle of {} rad; expected at most {}", angle, largestAngle));
    }
    return angle;
}

} // namespace

int Sandbox::Functions::charge(lua_State* L) {
    of(L).charge(L, luaL_checknumber(L, 1));
    return 0;
}

int Sandbox::Functions::show(lua_State* L) {
    std::string shown = textAt(L, 1);
    if (lua_type(L, 1) == LUA_TNUMBER) {
        shown = fmt::format("[{}]", lua_tonumber(L, 1));
    } else if (lua_type(L, 1) != LUA_TSTRING) {
        shown = fmt::format("[{}]", kindOf(L, 1));
    }
    shown.resize(std::min<std::size_t>(shown.size(), 60));
    pushString(L, shown);
    return 1;
}

int Sandbox::Functions::suggest(lua_State* L) {
    std::string const word = textAt(L, 1);
    of(L).charge(L, chargePerSuggestion);
    std::vector<std::string> const known = stringKeys(L, 2);
    pushString(L, word.empty() || word.size() > 60 ? std::string() : didYouMean(word, known));
    return 1;
}

int Sandbox::Functions::list(lua_State* L) {
    of(L).charge(L, chargePerSuggestion);
    std::string all;
    for (std::string const& key : stringKeys(L, 1)) {
        all += ", " + key;
    }
    pushString(L, all);
    return 1;
}

int Sandbox::Functions::kind(lua_State* L) {
    pushString(L, kindOf(L, 1));
    return 1;
}

int Sandbox::Functions::log(lua_State* L) {
    Sandbox& sandbox = of(L);
    std::string line = textAt(L, 1);
    line.resize(std::min(line.size(), longestLogLine));
    if (sandbox.logged_ < sandbox.limits_.logLines && sandbox.onLog) {
        ++sandbox.logged_;
        sandbox.onLog(line);
    }
    return 0;
}

int Sandbox::Functions::limited(lua_State* L) {
    Sandbox const& sandbox = of(L);
    lua_pushboolean(L, !sandbox.stopped_.empty() || sandbox.memory_.exhausted() ? 1 : 0);
    return 1;
}

int Sandbox::Functions::limitText(lua_State* L) {
    Sandbox const& sandbox = of(L);
    pushString(L, sandbox.stopped_.empty() ? std::string_view("not enough memory") : sandbox.stopped_);
    return 1;
}

std::string Sandbox::Functions::part(lua_State* L, int index) {
    if (lua_type(L, index) != LUA_TSTRING && lua_type(L, index) != LUA_TNUMBER) {
        of(L).raise(
            L, fmt::format("a {} cannot be joined to a text; tostring() makes it one", kindOf(L, index)));
    }
    lua_pushvalue(L, index); // a copy, as lua_tolstring() converts a number in its place
    std::size_t size = 0;
    char const* const text = lua_tolstring(L, -1, &size);
    std::string copy(text, size);
    lua_pop(L, 1);
    return copy;
}

int Sandbox::Functions::join(lua_State* L) {
    of(L).pushText(L, part(L, 1) + part(L, 2));
    return 1;
}

int Sandbox::Functions::plain(lua_State* L) {
    of(L).pushText(L, part(L, 1));
    return 1;
}

int Sandbox::Functions::keepGarbage(lua_State* L) {
    of(L).keepsGarbage_ = true;
    lua_gc(L, LUA_GCSTOP, 0);
    return 0;
}

int Sandbox::Functions::sin(lua_State* L) {
    lua_pushnumber(L, exactSin(angleAt(L)));
    return 1;
}

int Sandbox::Functions::cos(lua_State* L) {
    lua_pushnumber(L, exactCos(angleAt(L)));
    return 1;
}

int Sandbox::Functions::atan2(lua_State* L) {
    lua_pushnumber(L, exactAtan2(luaL_checknumber(L, 1), luaL_checknumber(L, 2)));
    return 1;
}

int Sandbox::Functions::exp(lua_State* L) {
    lua_pushnumber(L, exactExp(luaL_checknumber(L, 1)));
    return 1;
}

int Sandbox::Functions::logE(lua_State* L) {
    lua_pushnumber(L, exactLog(luaL_checknumber(L, 1)));
    return 1;
}

luaL_Reg const Sandbox::Functions::all[] = {
    {"charge", charge}, {"show", show}, {"suggest", suggest}, {"list", list},
    {"kind", kind},     {"log", log},   {"limited", limited}, {"limitText", limitText},
    {"sin", sin},       {"cos", cos},   {"atan2", atan2},     {"exp", exp},
    {"log_e", logE},    {"join", join}, {"plain", plain},     {"keepGarbage", keepGarbage},
    {nullptr, nullptr}};

int Sandbox::Functions::over(lua_State* L) {
    of(L).over(L);
    return 0;
}

int Sandbox::Functions::body(lua_State* L) {
    auto const& body = *static_cast<Body const*>(lua_touserdata(L, 1));
    lua_settop(L, 0);
    body(L);
    return 0;
}

int Sandbox::Functions::handler(lua_State* L) {
    Sandbox& sandbox = of(L);
    sandbox.memory_.setHost(true);
    sandbox.error_.message = lua_type(L, 1) == LUA_TSTRING ? textAt(L, 1)
                             : lua_type(L, 1) == LUA_TNUMBER
                                 ? fmt::format("{}", lua_tonumber(L, 1))
                                 : fmt::format("the error is no text but a {}", kindOf(L, 1));
    constexpr std::size_t longest = 1000;
    sandbox.error_.message.resize(std::min(sandbox.error_.message.size(), longest));
    luaL_traceback(L, L, nullptr, 1);
    sandbox.error_.traceback = textAt(L, -1);
    sandbox.error_.traceback.resize(std::min(sandbox.error_.traceback.size(), 2 * longest));
    return 1;
}

} // namespace trembler::lua
