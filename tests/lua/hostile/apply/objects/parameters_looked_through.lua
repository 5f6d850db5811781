-- tries to look through a table of the host, in the order in which it keeps things
-- expect: error
for key, value in pairs(object.Position) do log(key, value) end
