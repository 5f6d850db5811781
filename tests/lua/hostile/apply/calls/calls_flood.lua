-- tries to make calls for ever
-- expect: limit
while true do out.addForce(object, vec2(1, 0)) end
