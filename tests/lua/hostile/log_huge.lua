-- tries to log a very long line
-- expect: harmless
log(('x'):rep(4000))
