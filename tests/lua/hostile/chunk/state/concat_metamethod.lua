-- tries to get at what stands between the operands of ..
-- expect: error
setmetatable({}, { __concat = function(a, b) return b end })
