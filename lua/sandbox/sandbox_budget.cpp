// The instructions and calls of a frame: counting them, and the errors that end a turn.
#include "lua/sandbox/prelude/signatures.hpp"
#include "lua/sandbox/sandbox.hpp"
#include "lua/sandbox/stack_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <lua.hpp>
#include <utility>

namespace trembler::lua {
namespace {

// Raising an error takes as long as this many instructions.
constexpr double chargePerError = 400;

/// More calls than this are endless recursion, of which the innermost ones say enough. Of finding them the
/// time grows with the square of their number.
constexpr int deepCalls = 100;

} // namespace

double Sandbox::left(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, counted_);
    lua_getupvalue(L, -1, counterAt_);
    double const instructions = lua_tonumber(L, -1);
    lua_pop(L, 2);
    return instructions;
}
void Sandbox::setLeft(lua_State* L, double instructions) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, counted_);
    lua_pushnumber(L, instructions);
    lua_setupvalue(L, -2, counterAt_);
    lua_pop(L, 1);
}

void Sandbox::charge(lua_State* L, double instructions) {
    if (!counting_) {
        return;
    }
    double const cost = std::clamp(instructions, 0.0, 1e15);
    double const now = left(L);
    if (now < cost) { // work that does not fit is not done
        setLeft(L, 0);
        over(L);
    }
    setLeft(L, now - cost);
}

void Sandbox::chargeText(lua_State* L, std::size_t applications) {
    charge(L, static_cast<double>(source_.chunk) +
                  static_cast<double>(source_.apply) * static_cast<double>(applications));
}

void Sandbox::chargeCall(lua_State* L, bool creates) {
    if (!counting_) {
        return;
    }
    calls_.made += 1;
    if (calls_.made > calls_.most) {
        stop(L, fmt::format("the script makes more than its {} calls in a frame", calls_.most));
    }
    creations_ += creates ? 1 : 0;
    if (creations_ > limits_.creations) {
        stop(L, fmt::format("the script creates more than its {} objects in a frame", limits_.creations));
    }
}

void Sandbox::over(lua_State* L) {
    if (!stopped_.empty()) {
        stop(L, stopped_);
    }
    if (memory_.exhausted()) {
        stop(L, "not enough memory");
    }
    stop(L, fmt::format("the script takes more than its {} instructions in a frame", budget_));
}

// From here on every counter in the text raises the error again, so no pcall can suppress it.
void Sandbox::stop(lua_State* L, std::string const& message, bool placed) {
    if (&message != &stopped_) {
        spent_ = static_cast<std::uint64_t>(std::clamp(budget_ - left(L), 0.0, budget_));
        stopped_ = (placed ? placeOf(L) : std::string()) + message;
        setLeft(L, -1);
    }
    pushString(L, stopped_);
    lua_error(L);
    std::abort(); // lua_error() does not return
}

void Sandbox::endBy(lua_State* L, std::exception_ptr exception) {
    kept_ = kept_ ? kept_ : std::move(exception);
    std::string const message = "exception"; // so short that it needs no memory
    if (counting_) {
        stop(L, message, false);
    }
    pushString(L, message);
    lua_error(L);
    std::abort(); // lua_error() does not return
}

void Sandbox::raise(lua_State* L, std::string const& message) {
    charge(L, chargePerError);
    std::string const whole = placeOf(L) + message;
    pushString(L, whole);
    lua_error(L);
    std::abort(); // lua_error() does not return
}

void Sandbox::checkArguments(lua_State* L, std::string_view function) {
    std::string const fault = faultOfArguments(L, hostFunction(function));
    if (!fault.empty()) {
        raise(L, fault);
    }
}

void Sandbox::noteRefusal() {
    if (running_ != nullptr && counting_ && refusedAt_.empty()) {
        lua_Debug at{};
        refusedDeep_ = lua_getstack(running_, deepCalls, &at) != 0;
        refusedAt_ = placeOf(running_);
        refusedCalls_ = refusedDeep_ ? callsOf(running_) : std::string();
    }
}

// Lua's own traceback has addresses of the host's functions in it, and the host's functions differ between
// trusted and untrusted scripts.
std::string Sandbox::callsOf(lua_State* L) {
    constexpr std::size_t mostLines = 12;
    std::string all;
    std::string last;
    std::size_t lines = 0;
    lua_Debug at{};
    for (int level = 0; lua_getstack(L, level, &at) != 0; ++level) {
        if (level > deepCalls) {
            return all + "...\n";
        }
        lua_getinfo(L, "Sl", &at);
        if (at.source[0] != '@' || at.currentline <= 0) {
            continue;
        }
        std::string line = fmt::format("{}:{}", at.short_src, at.currentline);
        if (at.linedefined > 1) {
            line += fmt::format(", in the function of line {}", at.linedefined);
        }
        if (line == last) {
            continue;
        }
        if (++lines > mostLines) {
            return all + "...\n";
        }
        all += line + "\n";
        last = std::move(line);
    }
    return all;
}

std::string Sandbox::placeOf(lua_State* L) {
    for (int level = 0; level < 20; ++level) { // the first of the callers that is the script
        lua_Debug at{};
        if (lua_getstack(L, level, &at) == 0) {
            break;
        }
        lua_getinfo(L, "Sl", &at);
        if (at.currentline > 0 && at.source[0] == '@') {
            return fmt::format("{}:{}: ", at.short_src, at.currentline);
        }
    }
    return {};
}

} // namespace trembler::lua
