// Numbers: the library math; and interaction(), by which a script states its manifest.
#include "lua/sandbox/prelude/parts.hpp"

namespace trembler::lua {

std::string_view numbersPart() {
    static constexpr std::string_view text = R"lua(
-- Numbers -------------------------------------------------------------------------------------------------------

local math = { abs = raw.math.abs, ceil = raw.math.ceil, floor = floor, sqrt = sqrt,
  huge = raw.math.huge, pi = raw.math.pi, sin = host.sin, cos = host.cos, atan2 = host.atan2, exp = host.exp,
}
function math.log(x, base)
  if base == nil then return host.log_e(x) end
  return host.log_e(x) / host.log_e(base)
end
function math.fmod(a, b) charge(200) return raw.math.fmod(a, b) end
function math.tan(angle) return host.sin(angle) / host.cos(angle) end
function math.atan(x) return host.atan2(x, 1) end
function math.deg(angle) return angle * (180 / 3.141592653589793) end
function math.rad(angle) return angle * (3.141592653589793 / 180) end
function math.min(a, ...)
  for i = 1, select("#", ...) do
    local b = select(i, ...)
    if type(b) ~= "number" then refuse("math.min", a, ...) end
    if b < a then a = b end
  end
  return a
end
function math.max(a, ...)
  for i = 1, select("#", ...) do
    local b = select(i, ...)
    if type(b) ~= "number" then refuse("math.max", a, ...) end
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

function env.interaction(manifest) return manifest end
)lua";
    return text;
}

} // namespace trembler::lua
