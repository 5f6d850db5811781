-- tries to reach what the host keeps
-- expect: error
return debug.getregistry()
