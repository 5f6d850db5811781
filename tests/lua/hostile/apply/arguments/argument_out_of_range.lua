-- tries to give the engine a force beyond its range
-- expect: error
out.addForce(object, vec2(1e300, 0))
