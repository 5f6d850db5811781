-- tries to see when memory is collected
-- expect: error
setmetatable({}, { __mode = 'k' })
