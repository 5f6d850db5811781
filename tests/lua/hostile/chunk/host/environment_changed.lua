-- tries to change the globals of the host's functions
-- expect: error
setfenv(1, {})
