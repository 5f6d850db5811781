-- tries to push the world
-- expect: error
out.addForce(world, vec2(1, 0))
