-- tries to loop for ever without a condition that could be seen
-- expect: limit
local n = 0
repeat n = n + 1 until n < 0
