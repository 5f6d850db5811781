-- tries to reach the table of globals
-- expect: error
_G.math = nil
