-- tries to learn from an error which of two keys lies at the lower address
-- expect: harmless
local _, why = pcall(pairs, { [{}] = 1, [print] = 2 })
assert(not why:find('table') and not why:find('function'))
