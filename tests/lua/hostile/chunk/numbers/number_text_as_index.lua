-- tries to let a library convert such a text
-- expect: error
local s = '1' .. 'e' .. '308'
while true do math.floor(s) end
