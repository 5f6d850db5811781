-- tries to pass a table of its own for an object
-- expect: error
out.addForce({ value = 1 }, vec2(0, 0))
