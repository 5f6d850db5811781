-- tries to double a string until memory is gone
-- expect: limit
local s = 'a'
while true do s = s .. s end
