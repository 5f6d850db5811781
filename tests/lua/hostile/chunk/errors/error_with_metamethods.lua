-- tries to run code while its error is handled
-- expect: error
local function f() while true do end end
error(setmetatable({}, { __index = f, __eq = f, __lt = f, __len = f, __call = f }))
