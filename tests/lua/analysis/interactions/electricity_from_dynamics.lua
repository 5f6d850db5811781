-- C++ compares the pairs that touch with those that it has connected. A script keeps no list of pairs; it goes by
-- those that have begun to touch and those that ceased to.
local function bothConduct(pair)
  return alive(pair.a) and alive(pair.b) and pair.a.conductor and pair.b.conductor
end

return interaction {
  name = "Electricity <- Dynamics",
  text = "Connects any new colliding objects (if both are conductors) and disconnects any previous colliding objects.",
  calls = "Electricity",
  reads = { "contacts", "conductor" },
  once = true,
  apply = function(world, params, out)
    for _, pair in ipairs(world.contacts.ended) do
      if bothConduct(pair) then
        out.removeConnection(pair.a, pair.b)
      end
    end
    for _, pair in ipairs(world.contacts.begun) do
      if bothConduct(pair) then
        out.addConnection(pair.a, pair.b)
      end
    end
  end,
}
