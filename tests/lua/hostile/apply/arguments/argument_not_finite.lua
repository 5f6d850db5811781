-- tries to give the engine a force that is no number
-- expect: error
out.addForce(object, vec2(0 / 0, 0))
