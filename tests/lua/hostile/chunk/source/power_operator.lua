-- tries to compute powers, whose last bits differ between compiled and interpreted code
-- expect: refused
return 2 ^ 0.5
