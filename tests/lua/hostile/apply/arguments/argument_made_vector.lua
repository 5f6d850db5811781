-- tries to pass a table of its own for a vector
-- expect: error
out.addForce(object, { x = 1, y = 'much' })
