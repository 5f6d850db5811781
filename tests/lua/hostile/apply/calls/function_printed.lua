-- tries to print the address of a function
-- expect: harmless
log(out.addForce, vec2, pcall)
