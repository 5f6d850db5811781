-- tries to search in the worst case
-- expect: limit
local s, n = ('a'):rep(4000), ('a'):rep(2000) .. 'b'
while true do s:find(n) end
