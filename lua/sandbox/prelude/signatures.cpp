#include "lua/sandbox/prelude/signatures.hpp"

#include "lua/sandbox/sandbox.hpp"
#include "lua/sandbox/stack_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <lua.hpp>
#include <stdexcept>
#include <utility>

namespace trembler::lua {
namespace {

struct KindWords {
    std::string_view name; ///< in the list below
    std::string_view expected;
    std::string_view refused; ///< Lua that is true if {} is of another kind
};

constexpr std::array<KindWords, 12> kindWords{{
    {"any", "a value", ""},
    {"number", "a number", "type({}) ~= 'number'"},
    {"text", "a text", "type({}) ~= 'string'"},
    {"function", "a function", "type({}) ~= 'function'"},
    {"callable", "a function", "not isCallable({})"},
    {"coroutine", "a coroutine", "type({}) ~= 'thread'"},
    {"table", "a table of the script's own", "not isOwn({})"},
    {"listed", "a table of the script's own", "not isListed({})"},
    {"looked", "a table of the script's own", "not isLooked({})"},
    {"vector", "a vector, vec2(x, y)", "not isVec({})"},
    {"index", "a number or '#'", "(type({0}) ~= 'number' and {0} ~= '#')"},
    {"object", "an object", ""}, // those functions are in C
}};

KindWords const& wordsOf(ArgumentKind kind) {
    return kindWords.at(static_cast<std::size_t>(kind));
}

/// A function, and its arguments as "NAME:KIND", "NAME?:KIND" if it may be left out, "...:KIND" for any
/// number.
constexpr std::array<std::pair<std::string_view, std::string_view>, 63> functions{{
    {"interaction", "description:table"},
    {"log", "...:any"},
    {"print", "...:any"},
    {"vec2", "x:number y:number"},
    {"vec2:length", "v:vector"},
    {"vec2:dot", "v:vector w:vector"},
    {"vec2:cross", "v:vector w:vector"},
    {"vec2:unit", "v:vector"},
    {"vec2:turned", "v:vector angle:number"},
    {"math.abs", "x:number"},
    {"math.ceil", "x:number"},
    {"math.floor", "x:number"},
    {"math.sqrt", "x:number"},
    {"math.fmod", "a:number b:number"},
    {"math.min", "a:number ...:number"},
    {"math.max", "a:number ...:number"},
    {"math.clamp", "x:number least:number most:number"},
    {"math.sin", "angle:number"},
    {"math.cos", "angle:number"},
    {"math.tan", "angle:number"},
    {"math.atan", "x:number"},
    {"math.atan2", "y:number x:number"},
    {"math.exp", "x:number"},
    {"math.log", "x:number base?:number"},
    {"math.deg", "angle:number"},
    {"math.rad", "angle:number"},
    {"string.len", "s:text"},
    {"string.lower", "s:text"},
    {"string.upper", "s:text"},
    {"string.reverse", "s:text"},
    {"string.sub", "s:text from:number to?:number"},
    {"string.byte", "s:text from?:number to?:number"},
    {"string.char", "...:number"},
    {"string.rep", "s:text n:number between?:text"},
    {"string.find", "s:text word:text from?:number plain?:any"},
    {"string.format", "form:text ...:any"},
    {"tostring", "value:any"},
    {"tonumber", "s:any base?:number"},
    {"ipairs", "list:listed"},
    {"pairs", "table:looked"},
    {"next", "table:looked key?:any"},
    {"select", "n:index ...:any"},
    {"unpack", "list:listed from?:number to?:number"},
    {"table.unpack", "list:listed from?:number to?:number"},
    {"table.insert", "list:table at:any value?:any"},
    {"table.remove", "list:table at?:number"},
    {"table.sort", "list:table before?:function"},
    {"table.concat", "list:listed between?:text from?:number to?:number"},
    {"type", "value:any"},
    {"assert", "value:any message?:any ...:any"}, // assert(f()) hands on all results
    {"error", "message?:any level?:number"},
    {"pcall", "f:callable ...:any"},
    {"xpcall", "f:callable handler:function ...:any"},
    {"setmetatable", "table:table meta?:table"},
    {"getmetatable", "value:any"},
    {"coroutine.create", "f:function"},
    {"coroutine.resume", "thread:coroutine ...:any"},
    {"coroutine.yield", "...:any"},
    {"coroutine.wrap", "f:function"},
    {"coroutine.status", "thread:coroutine"},
    {"alive", "object?:object"},
    {"same", "a?:object b?:object"},
    {"frame.random", ""},
}};

ArgumentKind kindNamed(std::string_view name) {
    auto const at = std::find_if(kindWords.begin(), kindWords.end(),
                                 [&](KindWords const& words) { return words.name == name; });
    return static_cast<ArgumentKind>(at - kindWords.begin());
}

HostFunction functionOf(std::string_view name, std::string_view stated) {
    HostFunction made{.name = name, .parameters = {}};
    while (!stated.empty()) {
        std::size_t const end = std::min(stated.find(' '), stated.size());
        std::size_t const colon = stated.find(':');
        std::string_view parameter = stated.substr(0, colon);
        ArgumentKind const kind = kindNamed(stated.substr(colon + 1, end - colon - 1));
        if (parameter == "...") {
            made.more = true;
            made.moreOf = kind;
        } else {
            bool const optional = parameter.ends_with('?');
            parameter.remove_suffix(optional ? 1 : 0);
            made.parameters.push_back({parameter, kind, optional});
        }
        stated.remove_prefix(std::min(end + 1, stated.size()));
    }
    return made;
}

/// How many arguments must be stated at least.
std::size_t leastOf(HostFunction const& function) {
    return static_cast<std::size_t>(std::count_if(function.parameters.begin(), function.parameters.end(),
                                                  [](HostParameter const& one) { return !one.optional; }));
}

bool isTableWith(lua_State* L, int index, void (Sandbox::*pushMark)(lua_State*) const) {
    if (lua_type(L, index) != LUA_TTABLE || lua_getmetatable(L, index) == 0) {
        return false;
    }
    lua_pushliteral(L, "__metatable");
    lua_rawget(L, -2);
    (Sandbox::of(L).*pushMark)(L);
    bool const is = lua_rawequal(L, -1, -2) != 0;
    lua_pop(L, 3);
    return is;
}

bool isOf(lua_State* L, int index, ArgumentKind kind) {
    int const type = lua_type(L, index);
    switch (kind) {
    case ArgumentKind::any:
        return true;
    case ArgumentKind::number:
        return type == LUA_TNUMBER;
    case ArgumentKind::text:
        return type == LUA_TSTRING;
    case ArgumentKind::function:
        return type == LUA_TFUNCTION;
    case ArgumentKind::callable:
        return type == LUA_TFUNCTION || type == LUA_TTABLE;
    case ArgumentKind::coroutine:
        return type == LUA_TTHREAD;
    case ArgumentKind::table:
        return isOf(L, index, ArgumentKind::listed) && !isTableWith(L, index, &Sandbox::pushReadingMark);
    case ArgumentKind::listed:
        return type == LUA_TTABLE && !isTableWith(L, index, &Sandbox::pushHostMark) &&
               !isTableWith(L, index, &Sandbox::pushVectorMark);
    case ArgumentKind::looked:
        return type == LUA_TTABLE && !isTableWith(L, index, &Sandbox::pushHostMark);
    case ArgumentKind::vector:
        return isTableWith(L, index, &Sandbox::pushVectorMark);
    case ArgumentKind::index:
        return type == LUA_TNUMBER || (type == LUA_TSTRING && textAt(L, index) == "#");
    case ArgumentKind::object:
        return kindOf(L, index) == "object";
    }
    return false;
}

/// The name by which a script calls it: v:length().
std::string callName(HostFunction const& function) {
    bool const method = function.name.starts_with("vec2:");
    return method ? "v" + std::string(function.name.substr(4)) : std::string(function.name);
}

/// Where the prelude holds the function.
std::string placeOf(HostFunction const& function) {
    if (function.name.starts_with("vec2:")) {
        return "methods." + std::string(function.name.substr(5));
    }
    return function.name.find('.') == std::string_view::npos ? "env." + std::string(function.name)
                                                             : std::string(function.name);
}

} // namespace

std::span<HostFunction const> hostFunctions() {
    static std::vector<HostFunction> const all = [] {
        std::vector<HostFunction> made;
        for (auto const& [name, stated] : functions) {
            made.push_back(functionOf(name, stated));
        }
        return made;
    }();
    return all;
}

HostFunction const& hostFunction(std::string_view name) {
    for (HostFunction const& function : hostFunctions()) {
        if (function.name == name) {
            return function;
        }
    }
    throw std::out_of_range(std::string(name));
}

std::string_view expectationOf(ArgumentKind kind) {
    return wordsOf(kind).expected;
}

std::string signatureOf(HostFunction const& function) {
    bool const method = function.name.starts_with("vec2:");
    std::string all;
    for (HostParameter const& parameter : function.parameters) {
        if (!method || &parameter != function.parameters.data()) {
            all += fmt::format("{}{}", all.empty() ? "" : ", ", parameter.name);
        }
    }
    if (function.more) {
        all += all.empty() ? "..." : ", ...";
    }
    return fmt::format("{}({})", callName(function), all);
}

std::string faultOfArguments(lua_State* L, HostFunction const& function) {
    std::size_t const least = leastOf(function);
    auto given = static_cast<std::size_t>(lua_gettop(L));
    while (given > least && lua_isnil(L, static_cast<int>(given))) {
        --given;
    }
    std::string const name = callName(function);
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        HostParameter const& parameter = function.parameters[i];
        int const at = static_cast<int>(i) + 1;
        bool const none = i >= given || (lua_isnil(L, at) && parameter.kind != ArgumentKind::any);
        if (!parameter.optional && none) {
            return fmt::format("argument '{}' of {} is missing; expected {}", parameter.name, name,
                               signatureOf(function));
        }
        if (!none && !isOf(L, at, parameter.kind)) {
            return fmt::format("argument '{}' of {} is {}; expected {}", parameter.name, name,
                               kindInWords(L, at), expectationOf(parameter.kind));
        }
    }
    for (std::size_t i = function.parameters.size(); i < given && function.more; ++i) {
        int const at = static_cast<int>(i) + 1;
        if (!isOf(L, at, function.moreOf)) {
            return fmt::format("argument {} of {} is {}; expected {}", at, name, kindInWords(L, at),
                               expectationOf(function.moreOf));
        }
    }
    if (!function.more && given > function.parameters.size()) {
        return fmt::format("{} is given {} arguments; expected {}", name, given, signatureOf(function));
    }
    return {};
}

std::string signaturesPart() {
    std::string text;
    for (HostFunction const& function : hostFunctions()) {
        bool const inC =
            function.name == "alive" || function.name == "same" || function.name == "frame.random";
        if (inC || function.name == "vec2" || (function.parameters.empty() && function.more)) {
            continue; // they check themselves, or take anything
        }
        std::string names;
        std::string wrong;
        bool presence = false; // it needs a value that may be nil, so the number of the arguments counts
        std::size_t number = 0;
        for (HostParameter const& parameter : function.parameters) {
            std::string const local = fmt::format("a{}", ++number);
            names += fmt::format("{}{}", number == 1 ? "" : ",", local);
            presence = presence || (parameter.kind == ArgumentKind::any && !parameter.optional);
            std::string const test = fmt::format(fmt::runtime(wordsOf(parameter.kind).refused), local);
            if (!test.empty()) {
                wrong +=
                    fmt::format("{}{}", wrong.empty() ? "" : " or ",
                                parameter.optional ? fmt::format("({} ~= nil and {})", local, test) : test);
            }
        }
        std::string const or_ = wrong.empty() ? "" : " or ";
        std::string const place = placeOf(function);
        if (presence) {
            wrong += fmt::format("{}select('#',...)<{}", or_, leastOf(function));
            if (!function.more) {
                wrong += fmt::format(" or select('#',...)>{}", number);
            }
            text += fmt::format(
                "do local f={0} {0}=function(...) local {1}=... if {2} then refuse('{3}',...) end "
                "return f(...) end end\n",
                place, names, wrong, function.name);
            continue;
        }
        if (!function.more) {
            wrong += or_ + "select('#',...)~=0";
        }
        text += fmt::format("do local f={0} {0}=function({1},...) if {2} then refuse('{3}',{1},...) end "
                            "return f({4}) end end\n",
                            place, names, wrong, function.name, function.more ? names + ",..." : names);
    }
    return text;
}

} // namespace trembler::lua
