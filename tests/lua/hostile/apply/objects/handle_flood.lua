-- tries to make handles and tables of their properties for ever
-- expect: limit
while true do
  for _, pair in ipairs(world.contacts.current) do local mass, shape = pair.a.Mass, pair.a.Shape end
end
