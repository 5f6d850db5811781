-- A number that lasts: the store is the only thing that a script keeps from one turn to the next. What it declares there
-- is part of the world's state, so a replay counts the same.
--
-- The contacts of a frame are news in that frame only. "begun" lists pairs that touch now and did not before, "brief"
-- those that touched in between and do not any more; a ball that bounces within one frame is in the second list.
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
    for _, touched in ipairs({ world.contacts.begun, world.contacts.brief }) do
      for _, pair in ipairs(touched) do
        if same(pair.a, plate) or same(pair.b, plate) then
          store.object.landed = store.object.landed + 1
        end
      end
    end
    -- Both calls are held: the last turn's ends when this one makes its own.
    if store.object.landed >= params.count then
      out.enableMagnet(plate)
    else
      out.disableMagnet(plate)
    end
  end,
}
