-- tries to resume itself
-- expect: harmless
local co
co = coroutine.create(function() return coroutine.resume(co) end)
assert(coroutine.resume(co))
