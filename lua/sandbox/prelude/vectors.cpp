// Vectors: vec2(), their operators and functions.
#include "lua/sandbox/prelude/parts.hpp"

namespace trembler::lua {

std::string_view vectorsPart() {
    static constexpr std::string_view text = R"lua(
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
)lua";
    return text;
}

} // namespace trembler::lua
