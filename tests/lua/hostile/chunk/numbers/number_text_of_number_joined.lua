-- tries to make such a text from a number by joining it to nothing
-- expect: error
local s = 1.7e308 .. ''
while true do local x = s + 0 end
