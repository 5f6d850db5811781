-- tries to see when memory is collected, by a mode that is set later
-- expect: harmless
local meta = {}
local t = setmetatable({}, meta)
meta.__mode = 'v'
t[1] = {}
for i = 1, 500 do local garbage = {} end
assert(t[1] ~= nil)
