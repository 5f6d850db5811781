-- tries to get a text that arithmetic takes for a long number, as an error
-- expect: harmless
local _, text = pcall(error, 1.7e308)
assert(not pcall(function() return text + 0 end))
