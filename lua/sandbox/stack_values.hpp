// Values on the stack of a Lua state, in the host's own types and words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

struct lua_State;

namespace trembler::lua {

/// The text at `index`; empty if there is no string. A number is left as it is.
[[nodiscard]] std::string textAt(lua_State* L, int index);
/// Pushes a string.
void pushString(lua_State* L, std::string_view text);
/// Collects the keys of the table at `index` that are strings, ascending.
[[nodiscard]] std::vector<std::string> stringKeys(lua_State* L, int index);
/// "a number", "a vector", "an object": the type of a value, in words.
[[nodiscard]] std::string kindOf(lua_State* L, int index);

} // namespace trembler::lua
