#include "lua/sandbox/prelude.hpp"

namespace trembler::lua {

// What is written in Lua is counted in instructions like the script itself, so none of it needs a bound of
// its own. What is Lua's own and takes longer the longer its arguments are is charged for (host.charge).
// Scripts reach none of the tables in here: libraries are handed out behind read-only tables, so nothing that
// a script does to them can last to its next turn.
std::string_view preludeText() {
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

-- Errors --------------------------------------------------------------------------------------------------------

local depth, made = 0, 0
local function enter()
  if depth >= 40 then error("pcall, xpcall and coroutines are nested more than 40 deep", 3) end
  local saved = depth
  depth = saved + 1
  return saved
end
-- A limit ends the turn: whoever catches it gets it thrown again.
local function leave(saved, ok, ...)
  depth = saved
  if not ok then
    if host.limited() then error(host.limitText(), 0) end
    charge(400) -- finding who catches an error takes as long
  end
  return ok, ...
end
function env.pcall(f, ...)
  local saved = enter()
  return leave(saved, rawpcall(f, ...))
end
function env.xpcall(f, handler, ...)
  check("function", handler, 2, "xpcall")
  local saved = enter()
  -- Instructions are not counted while the error of the counter itself is handled.
  return leave(saved, rawxpcall(f, function(e)
    if host.limited() then return e end
    return handler(e)
  end, ...))
end
env.error = error
env.assert = raw.assert
env.type = type
env.select = select
function env.tonumber(v, base)
  if type(v) == "string" then charge(#v / 8) end
  if base ~= nil then return raw.tonumber(v, base) end
  return raw.tonumber(v)
end
env.ipairs = raw.ipairs
env.getmetatable = rawgetmetatable

local function unwrap(ok, ...)
  if not ok then error((...), 0) end
  return ...
end
local coroutine = { yield = co.yield, status = co.status }
function coroutine.create(f)
  check("function", f, 1, "coroutine.create")
  if made >= 50 then error("more than 50 coroutines in one turn", 2) end
  made = made + 1
  return co.create(f)
end
function coroutine.resume(thread, ...)
  local saved = enter()
  return leave(saved, co.resume(thread, ...))
end
function coroutine.wrap(f)
  local thread = coroutine.create(f)
  return function(...) return unwrap(coroutine.resume(thread, ...)) end
end

function env.setmetatable(t, meta)
  check("table", t, 1, "setmetatable")
  if meta ~= nil then
    check("table", meta, 2, "setmetatable")
    if rawget(meta, "__gc") ~= nil or rawget(meta, "__mode") ~= nil then
      error("there is no __gc and no __mode, as they depend on when memory is collected", 2)
    end
    if rawget(meta, "__concat") ~= nil then error("there is no __concat; write a function", 2) end
    host.keepGarbage() -- __mode can be set later, so nothing is collected in the rest of the turn
  end
  return rawsetmetatable(t, meta)
end

-- Vectors -------------------------------------------------------------------------------------------------------

local Vec2 = { __metatable = false }
local methods = {}
local function vec2(x, y)
  if type(x) ~= "number" or type(y) ~= "number" then
    error("vec2(x, y) takes two numbers; got a " .. type(x) .. " and a " .. type(y), 2)
  end
  return rawsetmetatable({ x = x, y = y }, Vec2)
end
env.vec2 = vec2
local function isVec(v) return type(v) == "table" and rawgetmetatable(v) == false and rawget(v, "x") ~= nil end
local function both(a, b, what)
  if not (isVec(a) and isVec(b)) then error("cannot " .. what .. " a " .. host.kind(a) .. " and a " .. host.kind(b), 3) end
end
Vec2.__index = function(_, key)
  local method = methods[key]
  if method == nil then error("a vector has no '" .. show(key) .. "'; it has x, y" .. host.list(methods), 2) end
  return method
end
Vec2.__newindex = function(_, key) error("a vector has x and y, and no '" .. show(key) .. "'", 2) end
Vec2.__add = function(a, b) both(a, b, "add") return vec2(a.x + b.x, a.y + b.y) end
Vec2.__sub = function(a, b) both(a, b, "subtract") return vec2(a.x - b.x, a.y - b.y) end
Vec2.__unm = function(a) return vec2(-a.x, -a.y) end
Vec2.__mul = function(a, b)
  if type(a) == "number" then return vec2(a * b.x, a * b.y) end
  if type(b) == "number" then return vec2(a.x * b, a.y * b) end
  error("a vector is multiplied by a number; for two vectors there are a:dot(b) and a:cross(b)", 2)
end
Vec2.__div = function(a, b)
  if type(b) ~= "number" or type(a) == "number" then error("a vector is divided by a number", 2) end
  return vec2(a.x / b, a.y / b)
end
Vec2.__eq = function(a, b) return a.x == b.x and a.y == b.y end
function methods.length(v) return sqrt(v.x * v.x + v.y * v.y) end
function methods.dot(a, b) both(a, b, "multiply") return a.x * b.x + a.y * b.y end
function methods.cross(a, b) both(a, b, "multiply") return a.x * b.y - a.y * b.x end
function methods.unit(v)
  local long = sqrt(v.x * v.x + v.y * v.y)
  if long == 0 then return vec2(0, 0) end
  return vec2(v.x / long, v.y / long)
end
function methods.turned(v, angle)
  local c, s = host.cos(angle), host.sin(angle)
  return vec2(c * v.x - s * v.y, s * v.x + c * v.y)
end

-- Text ----------------------------------------------------------------------------------------------------------

local longest = 1000
local function text(v)
  local kind = type(v)
  if kind == "string" then return v end
  if kind == "number" then return plain(v) end
  if kind == "boolean" or kind == "nil" then return rawtostring(v) end
  if isVec(v) then
    charge(20)
    return "(" .. rawtostring(v.x) .. ", " .. rawtostring(v.y) .. ")"
  end
  return host.kind(v) -- an address would be another one in every run
end
env.tostring = text
local function joined(...)
  local line = ""
  for i = 1, select("#", ...) do
    line = line .. (i > 1 and " " or "") .. text((select(i, ...)))
    charge(#line / 8)
    if #line > longest then break end -- as much as can be logged is in it
  end
  return line
end
function env.log(...) host.log(joined(...)) end
env.print = env.log

local string = { len = function(s) return #check("string", s, 1, "string.len") end }
for _, name in raw.ipairs({ "lower", "upper", "reverse" }) do
  local f = str[name]
  string[name] = function(s) return plain(f(check("string", s, 1, "string." .. name))) end
end
function string.sub(s, i, j) return plain(str.sub(check("string", s, 1, "string.sub"), i, j)) end
function string.byte(s, i) return (str.byte(check("string", s, 1, "string.byte"), i or 1)) end
function string.char(...)
  if select("#", ...) > 100 then error("string.char takes at most 100 numbers", 2) end
  return plain(str.char(...))
end
function string.rep(s, n)
  check("string", s, 1, "string.rep")
  check("number", n, 2, "string.rep")
  if not (#s * n <= longest) or not (n <= longest) then error("string.rep makes at most " .. longest .. " bytes", 2) end
  return plain(str.rep(s, n))
end
function string.find(s, needle, init)
  check("string", s, 1, "string.find")
  check("string", needle, 2, "string.find")
  charge(#s / 4 + #s * #needle / 64)
  return str.find(s, needle, init or 1, true)
end
local formats = { d = "number", i = "number", f = "number", e = "number", g = "number", x = "number", s = "any" }
function string.format(form, ...)
  check("string", form, 1, "string.format")
  if #form > 500 then error("string.format takes a form of at most 500 bytes", 2) end
  local values, count = { ... }, 0
  local at = 1
  while true do
    local from = str.find(form, "%", at, true)
    if from == nil then break end
    local _, stop, letter = str.find(form, "^%%[-+ 0]*%d*%.?%d*(.)", from)
    if letter == nil then error("string.format: an unfinished %", 2) end
    if letter ~= "%" then
      count = count + 1
      local wanted = formats[letter]
      if wanted == nil then error("string.format has no %" .. letter .. "; it has %d %i %f %e %g %x %s", 2) end
      if wanted == "number" then
        if type(values[count]) ~= "number" then error("string.format: value " .. count .. " is no number", 2) end
      else
        values[count] = text(values[count])
        if #values[count] > longest then error("string.format takes at most " .. longest .. " bytes", 2) end
      end
      charge(20)
    end
    at = stop + 1
  end
  return plain(str.format(form, rawunpack(values, 1, count)))
end

local patterns = "there are no patterns, as they can run for ever; string.find(text, word) finds a word"
env.string = readOnly("string.", string, { match = patterns, gmatch = patterns, gsub = patterns,
  dump = "there is no compiled code" })
-- What stands between the operands of every .. in a script: see withCountedJoins().
do
  local right
  local function none() error("an operator .. without a text", 2) end
  local waiting = rawsetmetatable({}, { __metatable = false, __index = none, __newindex = none, __concat = function(left)
    local operand = right
    right = nil
    return host.join(left, operand)
  end })
  env[host.joiner] = rawsetmetatable({}, { __metatable = false, __concat = function(_, operand)
    right = operand
    return waiting
  end })
end
do
  local meta = rawgetmetatable("")
  meta.__index = env.string
  meta.__metatable = false
end

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

-- Numbers -------------------------------------------------------------------------------------------------------

local math = { abs = raw.math.abs, ceil = raw.math.ceil, floor = floor, sqrt = sqrt,
  huge = raw.math.huge, pi = raw.math.pi, sin = host.sin, cos = host.cos, atan2 = host.atan2, exp = host.exp,
  log = host.log_e }
function math.fmod(a, b) charge(200) return raw.math.fmod(a, b) end
function math.tan(angle) return host.sin(angle) / host.cos(angle) end
function math.atan(x) return host.atan2(x, 1) end
function math.deg(angle) return angle * (180 / 3.141592653589793) end
function math.rad(angle) return angle * (3.141592653589793 / 180) end
function math.min(a, ...)
  check("number", a, 1, "math.min")
  for i = 1, select("#", ...) do
    local b = select(i, ...)
    if b < a then a = b end
  end
  return a
end
function math.max(a, ...)
  check("number", a, 1, "math.max")
  for i = 1, select("#", ...) do
    local b = select(i, ...)
    if b > a then a = b end
  end
  return a
end
function math.clamp(x, least, most)
  if x < least then return least end
  if x > most then return most end
  return x
end
local chance = "random numbers are frame.random(), which a replay repeats"
local power = "powers differ from machine to machine; write x * x, or math.exp(y * math.log(x))"
env.math = readOnly("math.", math, { random = chance, randomseed = chance, pow = power })

function env.interaction(manifest)
  if type(manifest) ~= "table" then error("interaction takes a table: interaction { name = ..., ... }", 2) end
  return manifest
end

-- The script's globals ------------------------------------------------------------------------------------------

local absent = {}
for _, name in raw.ipairs({ "io", "os", "require", "module", "package", "dofile", "loadfile", "load", "loadstring",
    "debug", "jit", "ffi", "newproxy", "collectgarbage", "gcinfo", "getfenv", "setfenv", "rawget", "rawset",
    "rawequal", "bit", "_G" }) do
  absent[name] = "there is no '" .. name .. "': a script reads what it declares and calls functions of its resolver"
end
rawsetmetatable(env, { __index = function(_, key)
  error(absent[key] or "there is no '" .. show(key) .. "'" .. host.suggest(key, env), 2)
end })
local globalMeta = {
  __index = env,
  __newindex = function(_, key)
    error("'" .. show(key) .. "' is not declared: write 'local " .. show(key)
      .. "', or, for what is to last, declare it in store", 2)
  end,
  __metatable = false }
local globals = rawsetmetatable({}, globalMeta)
-- Globals of a script that assigns to none of them have what env has, so reading one takes one look. With the
-- libraries themselves, if the script assigns to no field of a table.
local function fill(plain)
  for key, value in next, env do
    rawset(globals, key, plain and contents[value] or value)
  end
end
return globals, env, function() depth, made = 0, 0 end, Vec2, fill
)lua";
    return text;
}

} // namespace trembler::lua
