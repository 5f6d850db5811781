-- tries to search in the worst case
-- expect: limit
local s, n = ('a'):rep(1000), ('a'):rep(500) .. 'b'
while true do s:find(n) end
