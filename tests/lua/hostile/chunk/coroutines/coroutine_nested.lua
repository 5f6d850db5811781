-- tries to nest coroutines until the stack of C overflows
-- expect: limit
local function f() return coroutine.wrap(f)() end
f()
