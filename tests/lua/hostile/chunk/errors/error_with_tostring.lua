-- tries to run code while its error is printed
-- expect: error
error(setmetatable({}, { __tostring = function() while true do end end }))
