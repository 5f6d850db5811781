-- tries to compare long strings that are nearly equal, for ever
-- expect: limit
local s = ('x'):rep(990)
local a, b = s .. 'a', s .. 'b'
while a < b do end
