-- tries to catch the limit at every depth
-- expect: limit
local function f() while true do pcall(pcall, f) end end
f()
