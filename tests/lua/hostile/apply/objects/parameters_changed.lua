-- tries to change its parameters
-- expect: error
params.speed = 5
