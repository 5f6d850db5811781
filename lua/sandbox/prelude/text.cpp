// Texts: tostring, log, the library string, and the operator .. of scripts.
#include "lua/sandbox/prelude/parts.hpp"

namespace trembler::lua {

std::string_view textPart() {
    static constexpr std::string_view text = R"lua(
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
)lua";
    return text;
}

} // namespace trembler::lua
