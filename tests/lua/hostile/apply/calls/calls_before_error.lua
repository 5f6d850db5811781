-- tries to leave a force behind when it fails
-- expect: error
out.addForce(object, vec2(1e6, 0))
error('done')
