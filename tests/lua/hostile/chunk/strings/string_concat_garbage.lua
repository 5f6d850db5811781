-- tries to copy long strings in few instructions
-- expect: limit
local s = ('x'):rep(900)
for i = 1, 1e9 do local t = s .. i end
