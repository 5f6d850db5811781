-- tries to make many texts from numbers
-- expect: limit
while true do string.char(120, 120, 120, 120) end
