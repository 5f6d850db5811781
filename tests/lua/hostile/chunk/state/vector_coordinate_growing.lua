-- tries to make a text beyond its limit by a vector that holds its own text
-- expect: harmless
local v = vec2(1, 2)
for i = 1, 2 do pcall(function() v.x = tostring(v) .. tostring(v) end) end
assert(tostring(v) == '(1, 2)')
