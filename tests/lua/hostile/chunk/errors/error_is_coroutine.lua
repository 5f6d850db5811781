-- tries to fail with something that runs
-- expect: error
error(coroutine.create(function() while true do end end))
