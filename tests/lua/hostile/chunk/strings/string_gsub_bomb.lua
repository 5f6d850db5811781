-- tries to build a string by replacing
-- expect: error
return ('x'):rep(1000):gsub('x', ('y'):rep(1000))
