-- tries to change the metatable of what the host has made
-- expect: error
setmetatable(vec2(1, 2), {})
