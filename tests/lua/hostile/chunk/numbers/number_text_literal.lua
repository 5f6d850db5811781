-- tries to state a number of many digits as a text, which arithmetic converts slowly
-- expect: refused
local s = '1e308'
while true do local x = s + 0 end
