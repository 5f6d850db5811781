// Tables: an order of their keys, sorting, and the library table.
#include "lua/sandbox/prelude/parts.hpp"

namespace trembler::lua {

std::string_view tablesPart() {
    static constexpr std::string_view text = R"lua(
-- Tables --------------------------------------------------------------------------------------------------------

local function less(a, b) return a < b end
-- Stable, and counted: Lua's own is neither.
local function sort(t, n, before)
  local from, to, width = t, {}, 1
  while width < n do
    local i = 1
    while i <= n do
      local left, right = i, i + width
      local leftEnd, rightEnd = i + width - 1, i + 2 * width - 1
      if leftEnd > n then leftEnd = n end
      if rightEnd > n then rightEnd = n end
      for k = i, rightEnd do
        if left <= leftEnd and (right > rightEnd or not before(from[right], from[left])) then
          to[k] = from[left]
          left = left + 1
        else
          to[k] = from[right]
          right = right + 1
        end
      end
      i = i + 2 * width
    end
    from, to = to, from
    width = 2 * width
  end
  if from ~= t then
    for i = 1, n do t[i] = from[i] end
  end
end

local order = { boolean = 1, number = 2, string = 3 }
local function keyLess(a, b)
  local x, y = type(a), type(b)
  if x ~= y then return order[x] < order[y] end
  if x == "boolean" then return not a and b end
  return a < b
end
local function sortedKeys(t, what)
  check("table", t, 1, what)
  local keys, n = {}, 0
  for key in next, t do
    if order[type(key)] == nil then
      error(what .. ": a key is a " .. host.kind(key) .. ", and only numbers, strings and booleans have an order", 3)
    end
    n = n + 1
    keys[n] = key
  end
  sort(keys, n, keyLess)
  return keys
end
-- In the order of the keys: that of Lua's own differs from state to state.
function env.pairs(t)
  local keys, i = sortedKeys(t, "pairs"), 0
  return function()
    while true do
      i = i + 1
      local key = keys[i]
      if key == nil then return nil end
      local value = rawget(t, key)
      if value ~= nil then return key, value end
    end
  end
end
function env.next(t, key)
  local keys = sortedKeys(t, "next")
  if key == nil then return keys[1], rawget(t, keys[1]) end
  for i = 1, #keys do
    if keys[i] == key then
      if keys[i + 1] == nil then return nil end
      return keys[i + 1], rawget(t, keys[i + 1])
    end
  end
  error("next: the table has no such key", 2)
end
local function unpack(t, from, to)
  check("table", t, 1, "unpack")
  from, to = from or 1, to or #t
  if to < from then return end
  if not (to - from < 200) then error("unpack gives at most 200 values", 2) end
  return rawunpack(t, from, to)
end
env.unpack = unpack
local table = { unpack = unpack }
function table.insert(t, a, b)
  check("table", t, 1, "table.insert")
  local n = #t
  if b == nil then
    t[n + 1] = a
    return
  end
  check("number", a, 2, "table.insert")
  if a < 1 or a > n + 1 or a ~= floor(a) then error("table.insert: the place is not in the list", 2) end
  for i = n, a, -1 do t[i + 1] = t[i] end
  t[a] = b
end
function table.remove(t, at)
  check("table", t, 1, "table.remove")
  local n = #t
  at = at or n
  if n == 0 then return nil end
  if at < 1 or at > n or at ~= floor(at) then error("table.remove: the place is not in the list", 2) end
  local value = t[at]
  for i = at, n - 1 do t[i] = t[i + 1] end
  t[n] = nil
  return value
end
function table.sort(t, before)
  check("table", t, 1, "table.sort")
  if before ~= nil then check("function", before, 2, "table.sort") end
  sort(t, #t, before or less)
end
function table.concat(t, between)
  check("table", t, 1, "table.concat")
  between = between or ""
  check("string", between, 2, "table.concat")
  local long = 0
  for i = 1, #t do
    local kind = type(t[i])
    if kind ~= "string" and kind ~= "number" then error("table.concat: entry " .. i .. " is a " .. kind, 2) end
    long = long + #rawtostring(t[i]) + #between
    if long > longest then error("table.concat makes at most " .. longest .. " bytes", 2) end
  end
  return plain(tab.concat(t, between))
end
env.table = readOnly("table.", table)
env.coroutine = readOnly("coroutine.", coroutine)
)lua";
    return text;
}

} // namespace trembler::lua
