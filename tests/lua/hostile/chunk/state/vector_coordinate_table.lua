-- tries to get an address by a vector whose coordinate is a table
-- expect: error
local v = vec2(1, 2)
v.x = {}
log(v)
