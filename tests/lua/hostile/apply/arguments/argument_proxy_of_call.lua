-- tries to pass the functions for an object
-- expect: error
out.addForce(out, vec2(0, 0))
