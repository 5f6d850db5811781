-- tries to loop in a condition
-- expect: limit
local function f() return true end
while f() do end
