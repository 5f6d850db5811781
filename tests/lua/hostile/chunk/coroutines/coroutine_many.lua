-- tries to make coroutines until memory is gone
-- expect: error
local all = {}
for i = 1, 1e6 do all[i] = coroutine.create(function() end) end
