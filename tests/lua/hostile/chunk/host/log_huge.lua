-- tries to log a very long line
-- expect: harmless
log(('x'):rep(1000), ('y'):rep(1000))
