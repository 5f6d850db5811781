// The globals of a script, and the values that the chunk returns to the host.
#include "lua/sandbox/prelude/parts.hpp"

namespace trembler::lua {

std::string_view globalsPart() {
    static constexpr std::string_view text = R"lua(
-- The script's globals ------------------------------------------------------------------------------------------

local absent = {}
for _, name in raw.ipairs({ "io", "os", "require", "module", "package", "dofile", "loadfile", "load", "loadstring",
    "debug", "jit", "ffi", "newproxy", "collectgarbage", "gcinfo", "getfenv", "setfenv", "rawget", "rawset",
    "rawequal", "bit", "_G" }) do
  absent[name] = "there is no '" .. name .. "': a script reads what it declares and calls functions of its resolver"
end
rawsetmetatable(env, { __index = function(_, key)
  err(absent[key] or "there is no '" .. show(key) .. "'" .. host.suggest(key, env))
end })
local globalMeta = {
  __index = env,
  __newindex = function(_, key)
    err("'" .. show(key) .. "' is not declared: write 'local " .. show(key)
      .. "', or, for what is to last, declare it in store")
  end,
  __metatable = hosts }
local globals = rawsetmetatable({}, globalMeta)
-- Globals of a script that assigns to none of them have what env has, so reading one takes one look. With the
-- libraries themselves, if the script assigns to no field of a table.
local function fill(plain)
  for key, value in next, env do
    rawset(globals, key, plain and contents[value] or value)
  end
end
return globals, env, function() depth, made = 0, 0 end, Vec2, fill, hosts, vectors, hide, hiddenX, hiddenY,
  ReadVec2, reading, inside
)lua";
    return text;
}

} // namespace trembler::lua
