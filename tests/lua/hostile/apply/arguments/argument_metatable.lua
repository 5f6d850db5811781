-- tries to pass a table that answers to everything
-- expect: error
out.addForce(setmetatable({}, { __index = function() return 1 end }), vec2(0, 0))
