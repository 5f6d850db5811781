-- tries to get an address by a table that is taken for a vector
-- expect: harmless
assert(tostring(setmetatable({ x = {}, y = print }, { __metatable = getmetatable(vec2(1, 2)) })) == 'table')
