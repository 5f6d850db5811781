-- tries to fail with a message of many kilobytes
-- expect: error
error(('x'):rep(4000))
