-- tries to switch the compiler on, whose loops cannot be stopped
-- expect: error
jit.on()
