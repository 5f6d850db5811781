-- tries to make a handle from a metatable
-- expect: error
setmetatable({}, getmetatable(object))
