-- tries to make a text beyond its limit of an error that is thrown again and again
-- expect: harmless
local text = ('a'):rep(1000)
for i = 1, 2 do local _, caught = pcall(function() error(text) end) text = caught end
assert(#text <= 1000)
