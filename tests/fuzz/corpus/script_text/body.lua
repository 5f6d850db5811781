for _, pair in ipairs(world.contacts.current) do
  if same(pair.a, object) then out.addImpulse(object, object.Position.value, vec2(0, object.Mass.value)) end
end
store.object.n = store.object.n + frame.random()
store.script.v = object.Velocity.value
