-- tries to be asked for a thousand names in every call
-- expect: limit
local t = {}
for i = 1, 500 do t['k' .. i] = i end
while true do pcall(out.addForce, t) end
