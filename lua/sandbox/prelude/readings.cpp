// Tables and lists that are made when a script reads them.
#include "lua/sandbox/prelude/parts.hpp"

namespace trembler::lua {

// A script that assigns to fields gets an empty table in place of each, in which the table itself stands
// under a key that no script can name: an assignment to a key that is not there can be refused, to one that
// is there it cannot. Other scripts get the tables themselves. Lua's own # and ipairs() call nothing for a
// table, so such a script has an operator and a function of its own for them: see
// CountedSource::assignsFields.
std::string_view readingsPart() {
    static constexpr std::string_view text = R"lua(
-- Readings ------------------------------------------------------------------------------------------------------

local inside = {}
local reading = { __metatable = readings, __newindex = host.refuseChange }
local function isReading(v) return hidden and type(v) == "table" and rawgetmetatable(v) == readings end
-- The table itself. No script may get it.
local function insideOf(v)
  if isReading(v) then return rawget(v, inside) end
  return v
end
local function hide()
  hidden = true
  reading.__index = function(t, key) return rawget(rawget(t, inside), key) end
end
local function nextEntry(t, i)
  local value = rawget(rawget(t, inside), i + 1)
  if value ~= nil then return i + 1, value end
end
function env.ipairs(t)
  if isReading(t) then return nextEntry, t, 0 end
  return raw.ipairs(t)
end
-- What stands between # and its operand, joined to it by ^, which binds as closely as #.
env[host.lengthener] = rawsetmetatable({}, { __metatable = hosts, __pow = function(_, v)
  if type(v) ~= "table" and type(v) ~= "string" then err("# is the length of a list or a text; this is " .. host.kind(v)) end
  return #insideOf(v)
end })
)lua";
    return text;
}

} // namespace trembler::lua
