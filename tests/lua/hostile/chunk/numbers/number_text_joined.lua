-- tries to let arithmetic convert a text that takes long: 0.1 ms in one instruction
-- expect: limit
local e = 'e'
local s = '1' .. e .. '308'
while true do pcall(function() return s + 0 end) end
