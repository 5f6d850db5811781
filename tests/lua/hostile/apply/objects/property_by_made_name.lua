-- tries to read by a name that it puts together
-- expect: error
local x = object['Rota' .. 'tion']
