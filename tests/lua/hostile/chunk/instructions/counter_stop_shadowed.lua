-- tries to be told itself that its instructions are used up
-- expect: refused
local function __over() end
while true do end
