// The part of a script's surroundings that is written in Lua.
#pragma once

#include <string_view>

namespace trembler::lua {

/// A chunk that is called once for each state, with Lua's own functions and those of the host, and returns
/// the table of globals that scripts see, and a function to be called before each turn.
[[nodiscard]] std::string_view preludeText();

} // namespace trembler::lua
