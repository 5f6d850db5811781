-- tries to make such a text of many digits
-- expect: error
local s = ('9'):rep(308)
while true do local x = s + 0 end
