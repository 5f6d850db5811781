-- tries to make such a text from a number
-- expect: error
local s = tostring(1.7e308)
while true do local x = s + 0 end
