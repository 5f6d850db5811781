-- tries to make functions until memory is gone
-- expect: limit
local all = {}
for i = 1, 1e9 do all[i] = function() return i end end
