-- tries to pass two hundred arguments
-- expect: error
local t = {}
for i = 1, 200 do t[i] = object end
out.addForce(unpack(t))
