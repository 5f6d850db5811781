-- tries to loop for ever while it is read
-- expect: refused
while true do end
