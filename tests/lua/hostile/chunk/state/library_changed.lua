-- tries to keep a state in a library
-- expect: error
math.mine = 1
