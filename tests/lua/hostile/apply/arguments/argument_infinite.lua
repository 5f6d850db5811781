-- tries to give the engine an infinite torque
-- expect: error
out.addTorque(object, math.huge)
