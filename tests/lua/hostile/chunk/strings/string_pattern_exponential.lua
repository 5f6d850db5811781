-- tries to run a pattern of exponential time
-- expect: error
local s = ('a?'):rep(28) .. ('a'):rep(28)
return ('a'):rep(28):match(s)
