-- tries to draw random numbers for ever
-- expect: limit
while true do frame.random() end
