-- tries to catch the limit of calls and go on
-- expect: limit
while true do pcall(out.addForce, object, vec2(1, 0)) end
