-- tries to move a long array again and again
-- expect: limit
local t = {}
while true do table.insert(t, 1, 1) end
