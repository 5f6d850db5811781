-- tries to raise and catch errors for ever, which takes longer than instructions do
-- expect: limit
while true do pcall(error) end
