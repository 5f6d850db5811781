-- tries to overflow the stack of every coroutine
-- expect: limit
local function f() return 1 + f() end
for i = 1, 50 do coroutine.resume(coroutine.create(f)) end
