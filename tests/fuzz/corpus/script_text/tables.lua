local t = { 3, 1, 2, k = "v" }
table.sort(t, function(a, b) return a > b end)
for k, v in pairs(t) do log(k, v) end
log(table.concat({ 1, 2 }, ","), unpack(t))
