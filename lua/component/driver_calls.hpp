// The functions by which a compiled turn makes calls, as text in Lua.
#pragma once

#include "lua/binding/call_plan.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace trembler::lua {

/// A name as a string literal of Lua that consists of escapes only.
[[nodiscard]] std::string quotedName(std::string_view name);

/// The function that a trusted script calls in place of makeCall(). It does the same as makeCall() for
/// arguments in the usual form, and passes all others on to it. `number` is the call's place in its role. For
/// a call with vectors there is a second function, which takes two numbers for each (spreadVectors()).
[[nodiscard]] std::string driverCallText(std::size_t number, CallDescription const& call,
                                         CallPlan const& plan);

} // namespace trembler::lua
