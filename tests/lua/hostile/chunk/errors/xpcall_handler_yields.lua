-- tries to leave the handler of errors by a yield
-- expect: harmless
assert(not xpcall(error, coroutine.yield))
