-- tries to hide an operator behind a line end that only some see
-- expect: refused
-- commentreturn 2 ^ 0.5
