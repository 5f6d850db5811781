-- tries to let arithmetic skip much white space before a digit
-- expect: error
local s = (' '):rep(990) .. '1'
while true do local x = s + 0 end
