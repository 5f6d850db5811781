-- tries to grow the list of arguments without end
-- expect: limit
local function f(...) return f(1, ...) end
f()
