-- tries to convert long texts with a base
-- expect: limit
local s = ('z'):rep(1000)
while true do tonumber(s, 36) end
