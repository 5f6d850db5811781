-- tries to loop by tail calls, which need no stack
-- expect: limit
local function f() return f() end
f()
