-- tries to count to a number that is never reached
-- expect: limit
for i = 1, math.huge do end
