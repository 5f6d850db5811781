// Errors, coroutines and metatables, as scripts see them.
#include "lua/sandbox/prelude/parts.hpp"

namespace trembler::lua {

std::string_view errorsPart() {
    static constexpr std::string_view text = R"lua(
-- Errors --------------------------------------------------------------------------------------------------------

local depth, made = 0, 0
local function enter()
  if depth >= 40 then err("pcall, xpcall and coroutines are nested more than 40 deep") end
  local saved = depth
  depth = saved + 1
  return saved
end
-- An error object that is a text comes from Lua itself, which bounds it by nothing.
local function caught(e, ...)
  if type(e) == "string" then return host.caught(e), ... end
  return e, ...
end
-- A limit ends the turn: whoever catches it gets it thrown again.
local function leave(saved, ok, ...)
  depth = saved
  if not ok then
    if host.limited() then error(host.limitText(), 0) end
    charge(400) -- finding who catches an error takes as long
    return ok, caught(...)
  end
  return ok, ...
end
function env.pcall(f, ...)
  local saved = enter()
  return leave(saved, rawpcall(f, ...))
end
function env.xpcall(f, handler, ...)
  local saved = enter()
  -- Instructions are not counted while the error of the counter itself is handled.
  return leave(saved, rawxpcall(f, function(e)
    if host.limited() then return e end
    return handler((caught(e)))
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
function env.getmetatable(v)
  local meta = rawgetmetatable(v)
  if meta == vectors or meta == hosts or meta == readings then return false end
  return meta
end

local function unwrap(ok, ...)
  if not ok then error((...), 0) end
  return ...
end
local coroutine = { yield = co.yield, status = co.status }
function coroutine.create(f)
  if made >= 50 then err("more than 50 coroutines in one turn") end
  made = made + 1
  return co.create(f)
end
function coroutine.resume(thread, ...)
  local saved = enter()
  return leave(saved, co.resume(thread, ...))
end
do
  local create, resume = coroutine.create, coroutine.resume
  function coroutine.wrap(f)
    local thread = create(f)
    return function(...) return unwrap(resume(thread, ...)) end
  end
end

function env.setmetatable(t, meta)
  if meta ~= nil then
    if rawget(meta, "__gc") ~= nil or rawget(meta, "__mode") ~= nil then
      err("there is no __gc and no __mode, as they depend on when memory is collected")
    end
    if rawget(meta, "__concat") ~= nil then err("there is no __concat; write a function") end
    host.keepGarbage() -- __mode can be set later, so nothing is collected in the rest of the turn
  end
  return rawsetmetatable(t, meta)
end
)lua";
    return text;
}

} // namespace trembler::lua
