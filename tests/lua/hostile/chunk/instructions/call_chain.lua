-- tries to loop through __call
-- expect: limit
local m = {}
m.__call = function(self) return self() end
setmetatable({}, m)()
