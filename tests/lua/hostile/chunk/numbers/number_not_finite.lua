-- tries to make numbers that are none
-- expect: harmless
local nan, inf = 0 / 0, 1 / 0
assert(nan ~= nan and inf > 1e308)
