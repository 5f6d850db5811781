-- tries to return nothing
-- expect: refused
local x = 1
