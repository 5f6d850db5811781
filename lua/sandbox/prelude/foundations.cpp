// The basis of the other parts of the prelude: Lua's own functions under short names, read-only tables, and
// checks of arguments.
#include "lua/sandbox/prelude/parts.hpp"

namespace trembler::lua {

std::string_view foundationsPart() {
    static constexpr std::string_view text = R"lua(
local raw, host = ...
local type, error, select, next = raw.type, raw.error, raw.select, raw.next
local rawset, rawget = raw.rawset, raw.rawget
local rawsetmetatable, rawgetmetatable = raw.setmetatable, raw.getmetatable
local rawpcall, rawxpcall, rawunpack = raw.pcall, raw.xpcall, raw.unpack
local floor, sqrt = raw.math.floor, raw.math.sqrt
local charge, show, plain = host.charge, host.show, host.plain
local err, refuse = host.fail, host.refuse -- errors with the place in the script, whoever has called
local str, tab, co = raw.string, raw.table, raw.coroutine
local env = {}

-- What raw.getmetatable() gives for a vector, and for every other table of the host. No script gets them, so none
-- can make a table that is taken for one of these. `readings` are tables that are made when a script reads them: it
-- may look through them.
local vectors, hosts, readings = {}, {}, {}

local contents = {} -- of a read-only table, by that table
local function readOnly(name, content, why)
  local function keep(_, key) err(name .. show(key) .. " cannot be changed") end
  rawsetmetatable(content, {
    __index = function(_, key)
      err(why and why[key] or "there is no " .. name .. show(key) .. host.suggest(key, content))
    end,
    __newindex = keep,
    __metatable = hosts,
    __name = "library" })
  local shown = rawsetmetatable({}, { __index = content, __newindex = keep, __metatable = hosts, __name = "library" })
  contents[shown] = content
  return shown
end

-- Kinds of arguments: see signatures.hpp. A table of the host is none that a script may look through or change.
local function isVec(v) return type(v) == "table" and rawgetmetatable(v) == vectors end
local function isListed(v) return type(v) == "table" and rawgetmetatable(v) ~= hosts and rawgetmetatable(v) ~= vectors end
local function isOwn(v) return isListed(v) and rawgetmetatable(v) ~= readings end
local function isLooked(v) return type(v) == "table" and rawgetmetatable(v) ~= hosts end
-- A place in a text or a list as whole number of 32 bits: Lua's own functions convert others differently from
-- machine to machine.
local function inRange(i)
  if i >= -2147483648 and i <= 2147483647 then return i end
  return i > 0 and 2147483647 or -2147483648
end
local function isCallable(v) return type(v) == "function" or type(v) == "table" end
)lua";
    return text;
}

} // namespace trembler::lua
