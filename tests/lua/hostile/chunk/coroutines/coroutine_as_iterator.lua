-- tries to iterate over a coroutine that never ends
-- expect: limit
for x in coroutine.wrap(function() while true do coroutine.yield(1) end end) do end
