// A turn of a sandbox: running functions that may fail, within limits, and the state after it.
#include "lua/sandbox/prelude/host_functions.hpp"
#include "lua/sandbox/sandbox.hpp"
#include "lua/sandbox/stack_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <lua.hpp>
#include <utility>

namespace trembler::lua {

std::optional<ScriptError> Sandbox::protect(Body const& body) {
    memory_.setHost(true);
    auto failed = run(state_, body);
    throwKept();
    return failed;
}

void Sandbox::throwKept() {
    if (kept_) {
        std::rethrow_exception(std::exchange(kept_, nullptr));
    }
}

// A stack keeps the size to which a script has made it grow, and how far it can grow depends on it.
std::optional<ScriptError> Sandbox::runOnNewStack(Body const& body) {
    std::optional<ScriptError> failed;
    memory_.setHost(true);
    auto noStack = run(state_, [&](lua_State* L) {
        running_ = lua_newthread(L);
        failed = run(running_, body);
        running_ = nullptr;
    });
    running_ = nullptr;
    return noStack ? std::move(noStack) : std::move(failed);
}

void Sandbox::beginTurn(std::size_t objects, TurnOf of) {
    if (of == TurnOf::newFrame) {
        budget_ = left_ = static_cast<double>(limits_.instructions);
        mostAllocated_ = limits_.allocation;
        allocated_ = 0;
        calls_ = {.made = 0, .most = static_cast<double>(limits_.calls)};
        creations_ = 0;
        logged_ = 0;
    }
    auto const more = static_cast<double>(limits_.instructionsPerObject * objects);
    budget_ += more;
    left_ += more;
    mostAllocated_ += limits_.allocationPerObject * objects;
    calls_.most += static_cast<double>(limits_.callsPerObject) * static_cast<double>(objects);
    memory_.beginTurn(trusted() ? static_cast<std::size_t>(-1)
                                : mostAllocated_ - std::min(mostAllocated_, allocated_));
    memory_.setCap(memory_.used() +
                   mostMemory()); // garbage of earlier turns takes nothing away from this one
}

std::optional<ScriptError> Sandbox::turn(std::size_t objects, Body const& body, TurnOf of) {
    if (plainGlobals_ &&
        !filled_) { // before the turn, or the first one would have less memory than the others
        filled_ = true;
        if (auto failed = protect([this](lua_State* L) {
                lua_rawgeti(L, LUA_REGISTRYINDEX, fill_);
                lua_pushboolean(L, source_.assignsFields ? 0 : 1);
                lua_call(L, 1, 0);
            })) {
            return failed;
        }
    }
    beginTurn(objects, of);
    counting_ = true;
    Body const whole = [&](lua_State* L) {
        lua_rawgeti(L, LUA_REGISTRYINDEX, reset_);
        lua_call(L, 0, 0);
        setLeft(L, left_);
        body(L);
    };
    memory_.setHost(true);
    auto failed = trusted() ? run(state_, whole) : runOnNewStack(whole);
    counting_ = false;
    finishTurn(failed);
    throwKept();
    return failed;
}

void Sandbox::finishTurn(std::optional<ScriptError>& failed) {
    allocated_ += memory_.allocated();
    if (std::exchange(keepsGarbage_, false) || (!trusted() && memory_.worthCollecting())) {
        collect(); // garbage of the turn, so that the next one can have all of the memory
    }
    if (stopped_.empty()) {
        left_ = std::clamp(left(state_), 0.0, budget_);
        spent_ = static_cast<std::uint64_t>(budget_ - left_);
    }
    setLeft(state_, unlimited);         // neither needs memory beyond the stack that every state has
    if (!failed && !stopped_.empty()) { // its error was dropped
        failed = ScriptError{stopped_, {}, true};
    }
    if (!failed && memory_.exhausted()) {
        failed = ScriptError{"not enough memory", {}, true};
    }
    if (failed && (!stopped_.empty() || memory_.exhausted())) {
        failed->limit = true;
        if (!stopped_.empty() && failed->message.find(stopped_) == std::string::npos) {
            failed->message = stopped_; // the script has replaced the error
        } else if (stopped_.empty()) {
            failed->message =
                refusedDeep_
                    ? fmt::format("{}{}", refusedAt_, tooDeep)
                    : fmt::format("{}the script needs more memory than its limits, {} bytes at a time "
                                  "and {} in a frame",
                                  refusedAt_, mostMemory(), mostAllocated_);
        }
    }
    stopped_.clear();
    refusedAt_.clear();
    refusedDeep_ = false;
    refusedCalls_.clear();
    memory_.beginTurn(static_cast<std::size_t>(-1));
    memory_.setCap(mostMemory());
}

void Sandbox::collect() {
    memory_.beginCollection();
    lua_gc(state_, LUA_GCCOLLECT, 0); // Nothing here has a finaliser.
    lua_gc(state_, trusted() ? LUA_GCRESTART : LUA_GCSTOP, 0);
    memory_.endCollection();
}

std::optional<ScriptError> Sandbox::run(lua_State* L, Body const& body) {
    error_ = {};
    int const top = lua_gettop(L);
    // Pushing these needs no memory beyond the stack that every state has.
    lua_pushcfunction(L, guarded<Functions::handler>);
    lua_pushcfunction(L, guarded<Functions::body>);
    lua_pushlightuserdata(L, const_cast<Body*>(&body)); // NOLINT: it is called as const
    int const status = lua_pcall(L, 1, 0, top + 1);
    memory_.setHost(true);
    std::optional<ScriptError> failed;
    if (status != 0) {
        failed = std::move(error_);
        if (failed->message.empty()) {
            failed->message = status == LUA_ERRMEM ? "not enough memory" : textAt(L, -1);
            failed->traceback = std::exchange(refusedCalls_, {});
        }
    }
    lua_settop(L, top);
    return failed;
}

void Sandbox::callScript(lua_State* L, int arguments, int results) {
    memory_.setHost(trusted());
    lua_call(L, arguments, results);
    memory_.setHost(true);
    if (!trusted() && !keepsGarbage_ && memory_.worthCollecting()) {
        collect();
    }
}

} // namespace trembler::lua
