-- tries to make a gigabyte in one call
-- expect: error
local s = ('x'):rep(1e9)
