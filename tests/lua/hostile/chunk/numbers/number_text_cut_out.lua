-- tries to cut such a text out of its brackets
-- expect: error
local s = ('1' .. 'e' .. '308'):sub(2, -2)
while true do local x = s + 0 end
