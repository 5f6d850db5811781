-- tries to read the clock, which differs from run to run
-- expect: error
return os.clock()
