-- tries to overflow the stack
-- expect: limit
local function f() return 1 + f() end
f()
