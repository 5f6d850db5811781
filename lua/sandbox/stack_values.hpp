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
/// "number", "vector", "object", "world", "params": the type of a value, or which of the host's it is. Of
/// every value of one kind the same.
[[nodiscard]] std::string kindOf(lua_State* L, int index);
/// "a number", "an object", "the world", "nil": the same in a sentence.
[[nodiscard]] std::string kindInWords(lua_State* L, int index);
/// Every value as a script may see it as a text: no address is in it, and all runs have the same. Not
/// bounded.
[[nodiscard]] std::string shownText(lua_State* L, int index);
/// A number as Lua writes it, for every message that a script may see: of all that are not a number it writes
/// the same, where other functions show a sign, which differs between compiled and interpreted code.
[[nodiscard]] std::string numberText(lua_State* L, double number);

} // namespace trembler::lua
