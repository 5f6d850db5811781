-- tries to be no script at all
-- expect: refused
local = = 3
