-- tries to nest pcall in itself so that each level catches
-- expect: limit
local function f() while true do pcall(f) end end
f()
