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
  if isVec(t) then return { "x", "y" } end
  t = insideOf(t)
  local keys, n, ordered = {}, 0, true
  for key in next, t do
    if order[type(key)] == nil then ordered = false end
    n = n + 1
    keys[n] = key
  end
  -- Only now, and without the kind of the key: the order in which `next` finds them differs from run to run.
  if not ordered then
    err(what .. ": a key is an object, and only numbers, strings and booleans have an order")
  end
  sort(keys, n, keyLess)
  return keys
end
local function fieldOf(t, key)
  if isVec(t) then return t[key] end
  return rawget(insideOf(t), key)
end
-- In the order of the keys: that of Lua's own differs from state to state.
function env.pairs(t)
  local keys, i = sortedKeys(t, "pairs"), 0
  return function()
    while true do
      i = i + 1
      local key = keys[i]
      if key == nil then return nil end
      local value = fieldOf(t, key)
      if value ~= nil then return key, value end
    end
  end
end
function env.next(t, key)
  local keys = sortedKeys(t, "next")
  if key == nil then
    if keys[1] == nil then return nil end
    return keys[1], fieldOf(t, keys[1])
  end
  for i = 1, #keys do
    if keys[i] == key then
      if keys[i + 1] == nil then return nil end
      return keys[i + 1], fieldOf(t, keys[i + 1])
    end
  end
  err("next: the table has no such key")
end
local function unpack(t, from, to)
  t = insideOf(t)
  from, to = inRange(from or 1), inRange(to or #t)
  if to < from then return end
  if not (to - from < 200) then err("unpack gives at most 200 values") end
  return rawunpack(t, from, to)
end
env.unpack = unpack
local table = { unpack = unpack }
function table.insert(t, ...)
  local n, count, a, b = #t, select("#", ...), ...
  if count == 1 then
    if a == nil then err("argument 'value' of table.insert is nil; expected a value") end
    t[n + 1] = a
    return
  end
  if type(a) ~= "number" then
    err("argument 'at' of table.insert is " .. host.kind(a) .. "; expected a number")
  end
  if b == nil then err("argument 'value' of table.insert is nil; expected a value") end
  if not (a >= 1 and a <= n + 1 and a == floor(a)) then err("table.insert: the place is not in the list") end
  for i = n, a, -1 do t[i + 1] = t[i] end
  t[a] = b
end
function table.remove(t, at)
  local n = #t
  if n == 0 and (at == nil or at == 0) then return nil end
  at = at or n
  if not (at >= 1 and at <= n and at == floor(at)) then err("table.remove: the place is not in the list") end
  local value = t[at]
  for i = at, n - 1 do t[i] = t[i + 1] end
  t[n] = nil
  return value
end
function table.sort(t, before) sort(t, #t, before or less) end
function table.concat(t, between, from, to)
  t = insideOf(t)
  between, from, to = between or "", inRange(from or 1), inRange(to or #t)
  -- Of a list of its own: an entry may be another one when it is read again.
  local parts, long = {}, 0
  from, to = from - from % 1, to - to % 1
  for i = from, to do
    local part = t[i]
    local kind = type(part)
    if kind ~= "string" and kind ~= "number" then
      err("table.concat: entry " .. i .. " is " .. host.kind(part) .. "; expected a text or a number")
    end
    parts[#parts + 1] = part
    long = long + #text(part) + (i > from and #between or 0)
    if long > longest then err("table.concat makes at most " .. longest .. " bytes") end
  end
  return plain(tab.concat(parts, between))
end
env.table = readOnly("table.", table)
env.coroutine = readOnly("coroutine.", coroutine)
)lua";
    return text;
}

} // namespace trembler::lua
