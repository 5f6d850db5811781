// A Lua value as a JSON tree, which is easier to look through than the stack of a Lua state.
#pragma once

#include "lua/interaction/value.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>

struct lua_State;

namespace trembler::lua {

/// The value at `index`, counted from the bottom of the stack. A table with both a list and keys comes out as
/// its keys only; tables more than six deep, and values that are no boolean, number, text, vector, function
/// or table, come out as null. `depth` is that of the value itself, 0 at first. Counts instructions; raises a
/// Lua error beyond their limit.
[[nodiscard]] nlohmann::json treeOf(lua_State* L, int index, int depth);
/// Whether a value of the tree is a function.
[[nodiscard]] bool isFunction(nlohmann::json const& value);
/// A value of the tree as a script's value; nothing if it is a table, a function or null.
[[nodiscard]] std::optional<Value> valueOf(nlohmann::json const& value);

} // namespace trembler::lua
