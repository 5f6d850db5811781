-- tries to be a table that answers to every name
-- expect: refused
return setmetatable({}, { __index = function(_, key) return key end })
