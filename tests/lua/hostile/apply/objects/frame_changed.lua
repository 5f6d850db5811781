-- tries to change the time
-- expect: error
frame.duration = 1e9
