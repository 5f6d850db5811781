-- tries to loop for ever
-- expect: limit
while true do end
