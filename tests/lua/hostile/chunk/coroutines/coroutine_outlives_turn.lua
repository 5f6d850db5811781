-- tries to keep a coroutine suspended when the turn ends
-- expect: harmless
local co = coroutine.wrap(function() coroutine.yield() end)
co()
