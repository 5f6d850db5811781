-- Section 5.7.2 of the thesis asks what happens if two objects can be connected for two independent reasons, "if the air
-- between them is sufficiently humid" and "if the air between them is extremely hot". This is the first reason, hot.lua
-- the other one. They are independent: the electricity graph counts the connections of each interaction by
-- itself, so when the air dries, the connections by heat remain.
--
-- How humid the air is depends on how long something wet has been there, so it is kept in the store. It approaches the
-- humidity that belongs to what lies on the tray, by a share of what is missing in each second.
return interaction {
  name = "Electricity <- Humid air",
  text = "Water that lies on a tray makes the air above it humid, in time. Conductors that stand in humid air are connected "
    .. "with one another.",
  calls = "Electricity",
  reads = { "Position", "Material", "contacts", "Electrical state" },
  attached = true,
  each = { "Position" },
  restless = true,
  params = {
    reach = { default = 0.6, min = 0, max = 100, unit = "m", text = "How far the tray's air reaches" },
    per_drop = { default = 1, min = 0, max = 1, text = "Relative humidity that one wet thing gives in the end" },
    time = { default = 1.5, min = 0.01, max = 1000, unit = "s", text = "In which the difference falls to a third (1/e)" },
    conducts = { default = 0.8, min = 0, max = 1, text = "Relative humidity from which on the air conducts" },
  },
  store = { object = { humidity = 0 } },
  limits = { instructions_per_object = 2000, calls_per_object = 100 },
  apply = function(tray, params, out, store, frame)
    local wet = 0
    for _, pair in ipairs(world.contacts.current) do
      local other = (same(pair.a, tray) and pair.b) or (same(pair.b, tray) and pair.a) or nil
      if other and other.Material and other.Material.value == "water" then
        wet = wet + 1
      end
    end
    local final = math.min(1, wet * params.per_drop)
    local humidity = final + (store.object.humidity - final) * math.exp(-frame.duration / params.time)
    store.object.humidity = humidity
    if humidity < params.conducts then return end

    local within = {}
    for _, entry in ipairs(world["Electrical state"].objects) do
      local at = entry.object and entry.object.Position
      if at and (at.value - tray.Position.value):length() <= params.reach then
        for _, other in ipairs(within) do
          out.holdConnection(entry.object, other)
        end
        table.insert(within, entry.object)
      end
    end
  end,
}
