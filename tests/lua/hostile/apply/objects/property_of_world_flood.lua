-- tries to read a list again and again
-- expect: limit
while true do local x = world.contacts.current end
