-- tries to keep a state in a vector
-- expect: error
vec2(1, 2).mine = 3
