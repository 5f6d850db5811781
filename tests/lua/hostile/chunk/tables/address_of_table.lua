-- tries to get a number that differs from run to run
-- expect: harmless
assert(tostring({}) == 'table')
assert(tostring(print) == 'function')
