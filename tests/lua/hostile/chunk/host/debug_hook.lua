-- tries to take the counter of instructions away
-- expect: error
debug.sethook()
