-- tries to reach the globals of the host's functions
-- expect: error
return getfenv(pcall)
