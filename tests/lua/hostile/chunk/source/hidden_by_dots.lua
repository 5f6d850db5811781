-- tries to hide a concatenation behind the dots of varargs
-- expect: error
local function f(...) return .....'e308' end
while true do local x = f(1) + 0 end
