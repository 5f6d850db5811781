-- tries to give all numbers a metatable
-- expect: error
setmetatable(1, { __index = function() return 1 end })
