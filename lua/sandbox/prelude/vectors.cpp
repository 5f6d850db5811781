// Vectors: vec2(), their operators and functions.
#include "lua/sandbox/prelude/parts.hpp"

namespace trembler::lua {

// A vector is a table with the numbers x and y. A script that assigns to fields could put anything there, and
// Lua calls nothing for a key that a table has. So in its state the numbers stand under two keys that no
// script can name, and reading and setting x and y go through the metatable. Other scripts read the fields
// directly.
std::string_view vectorsPart() {
    static constexpr std::string_view text = R"lua(
-- Vectors -------------------------------------------------------------------------------------------------------

local Vec2 = { __metatable = vectors }
local methods = {}
local hiddenX, hiddenY, hidden = {}, {}, false
local function vec2(x, y)
  if hidden then return rawsetmetatable({ [hiddenX] = x, [hiddenY] = y }, Vec2) end
  return rawsetmetatable({ x = x, y = y }, Vec2)
end
function env.vec2(x, y, ...)
  if type(x) ~= "number" or type(y) ~= "number" or select("#", ...) ~= 0 then
    refuse("vec2", x, y, ...)
  end
  return vec2(x, y)
end
local function both(a, b, what)
  if not (isVec(a) and isVec(b)) then err("cannot " .. what .. " " .. host.kind(a) .. " and " .. host.kind(b)) end
end
Vec2.__index = function(v, key)
  if key == "x" then return rawget(v, hiddenX) end
  if key == "y" then return rawget(v, hiddenY) end
  local method = methods[key]
  if method == nil then err("a vector has no '" .. show(key) .. "'; it has x, y" .. host.list(methods)) end
  return method
end
Vec2.__newindex = function(v, key, value)
  if key ~= "x" and key ~= "y" then err("a vector has x and y, and no '" .. show(key) .. "'") end
  if type(value) ~= "number" then
    err("'" .. key .. "' of a vector cannot be " .. host.kind(value) .. "; expected a number")
  end
  rawset(v, key == "x" and hiddenX or hiddenY, value)
end
-- Of a vector that is a copy of what the script has read.
local ReadVec2 = {}
Vec2.__add = function(a, b) both(a, b, "add") return vec2(a.x + b.x, a.y + b.y) end
Vec2.__sub = function(a, b) both(a, b, "subtract") return vec2(a.x - b.x, a.y - b.y) end
Vec2.__unm = function(a) return vec2(-a.x, -a.y) end
Vec2.__mul = function(a, b)
  if type(a) == "number" then return vec2(a * b.x, a * b.y) end
  if type(b) == "number" then return vec2(a.x * b, a.y * b) end
  err("a vector is multiplied by a number; for two vectors there are a:dot(b) and a:cross(b)")
end
Vec2.__div = function(a, b)
  if type(b) ~= "number" or type(a) == "number" then err("a vector is divided by a number") end
  return vec2(a.x / b, a.y / b)
end
Vec2.__eq = function(a, b) return a.x == b.x and a.y == b.y end
for key, value in next, Vec2 do ReadVec2[key] = value end
ReadVec2.__newindex = host.refuseChange
function methods.length(v) return sqrt(v.x * v.x + v.y * v.y) end
function methods.dot(a, b) return a.x * b.x + a.y * b.y end
function methods.cross(a, b) return a.x * b.y - a.y * b.x end
function methods.unit(v)
  local long = sqrt(v.x * v.x + v.y * v.y)
  if long == 0 then return vec2(0, 0) end
  return vec2(v.x / long, v.y / long)
end
function methods.turned(v, angle)
  local c, s = host.cos(angle), host.sin(angle)
  return vec2(c * v.x - s * v.y, s * v.x + c * v.y)
end
)lua";
    return text;
}

} // namespace trembler::lua
