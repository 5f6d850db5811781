-- tries to double a string until memory is gone
-- expect: error
local s = 'a'
while true do s = s .. s end
