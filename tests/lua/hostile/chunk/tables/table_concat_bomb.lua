-- tries to join strings into a huge one
-- expect: error
local t = {}
for i = 1, 20 do t[i] = ('x'):rep(1000) end
return table.concat(t)
