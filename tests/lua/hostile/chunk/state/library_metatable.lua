-- tries to change a library through its metatable
-- expect: error
setmetatable(math, { __index = {} })
