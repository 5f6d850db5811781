// The basis of the other parts of the prelude: Lua's own functions under short names, read-only tables, and
// checks of arguments.
#include "lua/sandbox/prelude/parts.hpp"

namespace trembler::lua {

std::string_view foundationsPart() {
    static constexpr std::string_view text = R"lua(
local raw, host = ...
local type, error, select, next, rawtostring = raw.type, raw.error, raw.select, raw.next, raw.tostring
local rawset, rawget = raw.rawset, raw.rawget
local rawsetmetatable, rawgetmetatable = raw.setmetatable, raw.getmetatable
local rawpcall, rawxpcall, rawunpack = raw.pcall, raw.xpcall, raw.unpack
local floor, sqrt = raw.math.floor, raw.math.sqrt
local charge, show, plain = host.charge, host.show, host.plain
local str, tab, co = raw.string, raw.table, raw.coroutine
local env = {}

local contents = {} -- of a read-only table, by that table
local function readOnly(name, content, why)
  local function refuse(_, key) error(name .. show(key) .. " cannot be changed", 2) end
  rawsetmetatable(content, {
    __index = function(_, key)
      error(why and why[key] or "there is no " .. name .. show(key) .. host.suggest(key, content), 2)
    end,
    __newindex = refuse,
    __metatable = false })
  local shown = rawsetmetatable({}, { __index = content, __newindex = refuse, __metatable = false })
  contents[shown] = content
  return shown
end

local function check(wanted, value, position, what)
  local kind = type(value)
  if kind ~= wanted then
    error("argument " .. position .. " of " .. what .. " is a " .. kind .. "; expected a " .. wanted, 3)
  end
  return value
end
)lua";
    return text;
}

} // namespace trembler::lua
