-- tries to be asked for names without end
-- expect: error
local t = { object = object, force = vec2(0, 0) }
for i = 1, 500 do t['name ' .. i] = 1 end
out.addForce(t)
