-- tries to put a counter of its own before the host's
-- expect: refused
local __count = 1e9
while true do end
