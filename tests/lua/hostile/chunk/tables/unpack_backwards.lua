-- tries to confuse the bound of unpack
-- expect: harmless
assert(select('#', unpack({}, 1e15, 1)) == 0)
