-- tries to let a loop convert such a text
-- expect: error
local s = '1' .. 'e' .. '308'
for i = s, s do end
