-- tries to run code when memory is collected
-- expect: error
setmetatable({}, { __gc = function() while true do end end })
