-- tries to confuse sort by a comparison that contradicts itself
-- expect: harmless
local t = {}
for i = 1, 20 do t[i] = i end
table.sort(t, function() return true end)
assert(#t == 20)
