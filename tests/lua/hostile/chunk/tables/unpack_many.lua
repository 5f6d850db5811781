-- tries to put a million values on the stack
-- expect: error
return unpack({}, 1, 1e6)
