-- tries to get a counter of its own as a parameter
-- expect: refused
local function f(__count) while true do end end
f(1e9)
