// Texts: tostring, log, the library string, and the operator .. of scripts.
#include "lua/sandbox/prelude/parts.hpp"

namespace trembler::lua {

std::string_view textPart() {
    static constexpr std::string_view text = R"lua(
-- Text ----------------------------------------------------------------------------------------------------------

local longest = 1000
-- The one door by which a value becomes a text of a script. No text has an address in it.
local function text(v)
  if type(v) == "string" then return v end
  return host.text(v)
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

local string = { len = function(s) return #s end }
for _, name in raw.ipairs({ "lower", "upper", "reverse" }) do
  local f = str[name]
  string[name] = function(s) return plain(f(s)) end
end
function string.sub(s, i, j) return plain(str.sub(s, inRange(i), inRange(j or -1))) end
-- One byte, or nil, without `j`; else as many as there are.
function string.byte(s, i, j)
  i = inRange(i or 1)
  if j == nil then return (str.byte(s, i)) end
  j = inRange(j)
  local from, to = i < 0 and i + #s + 1 or i, j < 0 and j + #s + 1 or j
  if (to < #s and to or #s) - (from > 1 and from or 1) >= 200 then err("string.byte gives at most 200 values") end
  return str.byte(s, i, j)
end
function string.char(...)
  for i = 1, select("#", ...) do
    if type((select(i, ...))) ~= "number" then refuse("string.char", ...) end
  end
  if select("#", ...) > 100 then err("string.char takes at most 100 numbers") end
  return plain(str.char(...))
end
function string.rep(s, n, between)
  between = between or ""
  if not ((#s + #between) * n - #between <= longest) or not (n <= longest) then
    err("string.rep makes at most " .. longest .. " bytes")
  end
  return plain(str.rep(s, n, between))
end
local patterns = "there are no patterns, as they can run for ever; string.find(text, word) finds a word"
function string.find(s, needle, init, literal)
  charge(#s / 4 + #s * #needle / 64)
  -- A script that leaves out the fourth argument wants a word, and one that states false a pattern.
  if literal == false and str.find(needle, "[%^$*+?.(%[%%-]") then err(patterns) end
  return str.find(s, needle, inRange(init or 1), true)
end
-- Numbers of %d, %i and %x are converted to whole ones, of which not every machine makes the same beyond these.
local formats = { d = "whole", i = "whole", u = "whole", o = "whole", x = "whole", X = "whole", c = "byte",
  f = "number", e = "number", E = "number", g = "number", G = "number", a = "number", A = "number",
  s = "any", q = "quoted" }
function string.format(form, ...)
  if #form > 500 then err("string.format takes a form of at most 500 bytes") end
  local values, given, count = { ... }, select("#", ...), 0
  local at = 1
  while true do
    local from = str.find(form, "%", at, true)
    if from == nil then break end
    local _, stop, width, digits, letter = str.find(form, "^%%[-+ 0]*(%d*)%.?(%d*)(.)", from)
    if letter == nil then err("string.format: an unfinished %") end
    if #width > 2 or #digits > 2 then err("string.format: a width or precision above 99") end
    if letter ~= "%" then
      count = count + 1
      local wanted, value = formats[letter], values[count]
      if wanted == nil then err("string.format has no %" .. show(letter) .. "; it has %d %i %u %o %x %X %c %f %e %E %g %G %a %A %q %s") end
      if count > given then err("string.format: value " .. count .. " is missing") end
      if wanted == "any" then
        values[count] = text(value)
      elseif wanted == "quoted" then
        if type(value) ~= "string" and type(value) ~= "number" then
          err("string.format: value " .. count .. " is " .. host.kind(value) .. "; expected a text or a number")
        end
        values[count] = text(value)
      elseif type(value) ~= "number" then
        err("string.format: value " .. count .. " is " .. host.kind(value) .. "; expected a number")
      elseif wanted == "whole" and not (value > -9223372036854775808 and value < 9223372036854775808) then
        err("string.format: value " .. count .. " is too large for %" .. letter)
      elseif wanted == "byte" and not (value >= 0 and value < 256) then
        err("string.format: value " .. count .. " of %c is no byte; expected a number from 0 to 255")
      end
      charge(20)
    end
    at = stop + 1
  end
  if count < given then err("string.format is given " .. given .. " values; the form has " .. count) end
  return plain(str.format(form, rawunpack(values, 1, count)))
end

env.string = readOnly("string.", string, { match = patterns, gmatch = patterns, gsub = patterns,
  dump = "there is no compiled code" })
-- What stands between the operands of every .. in a script: see withCountedJoins().
do
  local right
  local function none() err("an operator .. without a text") end
  local waiting = rawsetmetatable({}, { __metatable = hosts, __index = none, __newindex = none, __concat = function(left)
    local operand = right
    right = nil
    return host.join(left, operand)
  end })
  env[host.joiner] = rawsetmetatable({}, { __metatable = hosts, __concat = function(_, operand)
    right = operand
    return waiting
  end })
end
do
  local meta = rawgetmetatable("")
  meta.__index = env.string
  meta.__metatable = false
end
)lua";
    return text;
}

} // namespace trembler::lua
