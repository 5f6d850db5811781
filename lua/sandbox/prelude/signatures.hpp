// The functions of the host that scripts call, with what they take: one list, by which all their arguments
// are checked.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

struct lua_State;

namespace trembler::lua {

enum class ArgumentKind {
    any,
    number,
    text,
    function,
    callable, ///< a function, or a table, which may have a metamethod for calls
    coroutine,
    table,  ///< of the script's own, no vector
    listed, ///< the same, or a table that was made when the script read it
    looked, ///< the same, or a vector
    vector,
    index,  ///< a number, or "#"
    object, ///< one of the objects that a script sees; the world is none
};

struct HostParameter {
    std::string_view name;
    ArgumentKind kind = ArgumentKind::any;
    bool optional = false; ///< may be left out, or nil
};

struct HostFunction {
    std::string_view name; ///< "math.clamp"; of a method of vectors, "vec2:length"
    std::vector<HostParameter> parameters;
    bool more = false;                       ///< takes any number of further arguments
    ArgumentKind moreOf = ArgumentKind::any; ///< their kind
};

/// All of them: those of the prelude, and alive(), same() and frame.random().
[[nodiscard]] std::span<HostFunction const> hostFunctions();
/// The one of that name; throws std::out_of_range if there is none.
[[nodiscard]] HostFunction const& hostFunction(std::string_view name);
/// "string.find(s, word, from)", for people.
[[nodiscard]] std::string signatureOf(HostFunction const& function);
/// "a number", "a table of the script's own": what an argument of that kind is.
[[nodiscard]] std::string_view expectationOf(ArgumentKind kind);

/// The fault of the arguments that are on the whole stack, in words; empty if there is none. Nils at the end
/// are ignored where they are no arguments of their own. Raises no error.
[[nodiscard]] std::string faultOfArguments(lua_State* L, HostFunction const& function);

/// The part of the prelude that lets each function in it check its arguments.
[[nodiscard]] std::string signaturesPart();

} // namespace trembler::lua
