-- tries to loop through __index functions
-- expect: limit
local t = {}
setmetatable(t, { __index = function(s, k) return s[k] end })
local x = t.x
