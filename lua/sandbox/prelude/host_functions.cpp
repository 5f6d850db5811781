// The functions of the host that Lua calls: the arguments of the prelude, and the functions by which the
// sandbox runs a script in protected mode.
#include "lua/sandbox/prelude/host_functions.hpp"

#include "lua/sandbox/number_text.hpp"
#include "lua/sandbox/prelude/signatures.hpp"
#include "lua/sandbox/stack_values.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/math/exact_math.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace trembler::lua {
namespace {

// Comparing a word with all known ones takes as long as this many instructions.
constexpr double chargePerSuggestion = 3000;

constexpr double chargePerVectorText = 20;

double angleAt(lua_State* L) {
    double const angle = lua_tonumber(L, 1); // the prelude has checked it, as in all functions below
    if (!(std::abs(angle) <= largestAngle)) {
        Sandbox::of(L).raise(L, fmt::format("an angle of {} rad; expected at most {}", numberText(L, angle),
                                            numberText(L, largestAngle)));
    }
    return angle;
}

/// A message without the place in the host's own Lua that LuaJIT has put before it.
std::string withoutOwnPlace(std::string text) {
    if (text.starts_with('(')) {
        for (std::string_view const chunk : {"(prelude):", "(driver):"}) {
            std::size_t const end = text.starts_with(chunk) ? text.find(": ") : std::string::npos;
            text.erase(0, end == std::string::npos ? 0 : end + 2);
        }
    }
    return text;
}

/// LuaJIT's message that the stack can grow no more, as the message of the limit that it is; nothing for
/// other texts. An untrusted script has no memory for such a stack, so a trusted one may not go on after it
/// either.
std::optional<std::string> tooDeepIn(std::string_view text) {
    std::size_t const at = text.find("stack overflow");
    if (at == std::string_view::npos) {
        return std::nullopt;
    }
    return fmt::format("{}{}", text.substr(0, at), Sandbox::tooDeep);
}

/// A text of a script in which no line ends, or a player could take its rest for a line of the program's own.
/// Other control characters are shown by whoever shows the text.
std::string inOneLine(std::string text) {
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at)) {
        text.replace(at, 1, "<U+000A>");
    }
    return text;
}

/// A key as messages show it.
std::string shownKey(lua_State* L, int index) {
    std::string shown = textAt(L, index);
    if (lua_type(L, index) == LUA_TNUMBER) {
        shown = fmt::format("[{}]", numberText(L, lua_tonumber(L, index)));
    } else if (lua_type(L, index) != LUA_TSTRING) {
        shown = fmt::format("[{}]", kindOf(L, index));
    }
    shown.resize(std::min<std::size_t>(shown.size(), 60));
    return shown;
}

} // namespace

int Sandbox::Functions::charge(lua_State* L) {
    of(L).charge(L, lua_tonumber(L, 1));
    return 0;
}

int Sandbox::Functions::show(lua_State* L) {
    pushString(L, shownKey(L, 1));
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
    pushString(L, kindInWords(L, 1));
    return 1;
}

int Sandbox::Functions::text(lua_State* L) {
    if (lua_type(L, 1) == LUA_TTABLE) {
        of(L).charge(L, chargePerVectorText);
    }
    of(L).pushText(L, shownText(L, 1));
    return 1;
}

/// An error's text, which LuaJIT or error() has made, as a text of the script.
int Sandbox::Functions::caught(lua_State* L) {
    std::string text = withoutOwnPlace(textAt(L, 1));
    if (auto const tooDeep = tooDeepIn(text)) {
        of(L).stop(L, *tooDeep, false);
    }
    text.resize(std::min(text.size(), longestString));
    of(L).pushText(L, text);
    return 1;
}

int Sandbox::Functions::fail(lua_State* L) {
    of(L).raise(L, textAt(L, 1));
}

/// What a script reads cannot be changed: raises the error of an assignment to the key at index 2.
int Sandbox::Functions::refuseChange(lua_State* L) {
    std::string const key = shownKey(L, 2);
    if (kindOf(L, 1) == "vector") {
        of(L).raise(L, fmt::format("'{}' of a vector that was read cannot be changed, as that would change "
                                   "nothing else; expected another vector, vec2(x, y), as in "
                                   "store.object.speed = vec2(x, y)",
                                   key));
    }
    of(L).raise(L, fmt::format("'{}' cannot be changed: an interaction changes nothing but by calling its "
                               "resolver, and what it keeps is in store",
                               key));
}

int Sandbox::Functions::refuse(lua_State* L) {
    HostFunction const& function = hostFunction(textAt(L, 1));
    lua_remove(L, 1);
    std::string const fault = faultOfArguments(L, function);
    if (!fault.empty()) {
        of(L).raise(L, fault);
    }
    return 0;
}

int Sandbox::Functions::log(lua_State* L) {
    Sandbox& sandbox = of(L);
    std::string line = inOneLine(textAt(L, 1));
    line.resize(std::min(line.size(), longestLogLine));
    if (sandbox.logged_ < sandbox.limits_.logLines && sandbox.onLog) {
        ++sandbox.logged_;
        sandbox.onLog(line);
    } else if (sandbox.logged_ == sandbox.limits_.logLines && sandbox.onLog) {
        ++sandbox.logged_; // said once
        sandbox.onLog(fmt::format("... further lines of this frame are left out; 'log_lines' in limits is {}",
                                  sandbox.limits_.logLines));
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
            L, fmt::format("{} cannot be joined to a text; tostring() makes it one", kindInWords(L, index)));
    }
    return shownText(L, index);
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
    lua_pushnumber(L, exactAtan2(lua_tonumber(L, 1), lua_tonumber(L, 2)));
    return 1;
}

int Sandbox::Functions::exp(lua_State* L) {
    lua_pushnumber(L, exactExp(lua_tonumber(L, 1)));
    return 1;
}

int Sandbox::Functions::logE(lua_State* L) {
    lua_pushnumber(L, exactLog(lua_tonumber(L, 1)));
    return 1;
}

luaL_Reg const Sandbox::Functions::all[] = {{"charge", guarded<charge>},
                                            {"show", guarded<show>},
                                            {"suggest", guarded<suggest>},
                                            {"list", guarded<list>},
                                            {"kind", guarded<kind>},
                                            {"text", guarded<text>},
                                            {"caught", guarded<caught>},
                                            {"fail", guarded<fail>},
                                            {"refuse", guarded<refuse>},
                                            {"log", guarded<log>},
                                            {"limited", guarded<limited>},
                                            {"limitText", guarded<limitText>},
                                            {"sin", guarded<sin>},
                                            {"cos", guarded<cos>},
                                            {"atan2", guarded<atan2>},
                                            {"exp", guarded<exp>},
                                            {"log_e", guarded<logE>},
                                            {"join", guarded<join>},
                                            {"plain", guarded<plain>},
                                            {"keepGarbage", guarded<keepGarbage>},
                                            {"refuseChange", guarded<refuseChange>},
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
    std::string text = lua_type(L, 1) == LUA_TSTRING || lua_type(L, 1) == LUA_TNUMBER
                           ? shownText(L, 1)
                           : fmt::format("the error is no text but {}", kindInWords(L, 1));
    if (std::string own = withoutOwnPlace(text); own != text) {
        text = placeOf(L) + own;
    }
    if (auto const tooDeep = tooDeepIn(text)) {
        text = *tooDeep;
        sandbox.error_.limit = true;
    }
    text = inOneLine(std::move(text));
    text.resize(std::min(text.size(), longestString));
    sandbox.error_.message = std::move(text);
    // Of a script that has caught this error and was stopped again, the calls are no longer those.
    bool const caught = sandbox.memory_.exhausted() ||
                        (!sandbox.stopped_.empty() && sandbox.stopped_.find(tooDeep) != std::string::npos);
    sandbox.error_.traceback = caught ? std::string() : callsOf(L);
    return 1;
}

} // namespace trembler::lua
