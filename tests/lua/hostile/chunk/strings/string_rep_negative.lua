-- tries to confuse the bound of string.rep
-- expect: harmless
assert(('x'):rep(-1e300) == '')
assert(not pcall(string.rep, 'x', 0/0))
assert(not pcall(string.rep, '', math.huge))
