return interaction {
  name = "Magnetics <- Pressure plate",
  text = "Counts how often something begins to touch the plate, and switches its magnet on from a number on.",
  calls = "Magnetics",
  reads = { "contacts" },
  attached = true,
  each = {},
  params = { count = { default = 1, min = 1, max = 1000, text = "How often something must land on it" } },
  store = { object = { landed = 0 } },
  apply = function(plate, params, out, store)
    for _, pairs_ in ipairs({ world.contacts.begun, world.contacts.brief }) do
      for _, pair in ipairs(pairs_) do
        if same(pair.a, plate) or same(pair.b, plate) then
          store.object.landed = store.object.landed + 1
        end
      end
    end
    if store.object.landed >= params.count then
      out.enableMagnet(plate)
    else
      out.disableMagnet(plate)
    end
  end,
}
