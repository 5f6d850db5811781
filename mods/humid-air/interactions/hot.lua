-- The second reason, see humid.lua: only the source of the state differs.
--
-- Newton's law of cooling: C dT/dt = P - G (T - T0). Over a frame, in which the power P stands, its solution is an
-- exponential, so the temperature is right for frames of any length.
return interaction {
  name = "Electricity <- Hot air",
  text = "Devices that turn electricity into heat warm the air above a tray, in time. Conductors that stand in hot air are "
    .. "connected with one another.",
  calls = "Electricity",
  reads = { "Position", "Electrical device", "Electrical quantities" },
  attached = true,
  each = { "Position" },
  restless = true,
  params = {
    reach = { default = 0.6, min = 0, max = 100, unit = "m", text = "How far the tray's air reaches" },
    heating = { default = 2.2, min = 0.01, max = 100, unit = "m", text = "The greatest distance of a device that heats it" },
    loss = { default = 1, min = 0.001, max = 1e6, unit = "W/K", text = "Heat that it loses for each degree" },
    capacity = { default = 2, min = 0.001, max = 1e6, unit = "J/K", text = "Heat that it takes for each degree" },
    conducts = { default = 300, min = 0, max = 1e5, unit = "K", text = "Above the surroundings, from which on it conducts" },
  },
  store = { object = { warmer = 0 } }, -- K, than the surroundings
  limits = { instructions_per_object = 2000, calls_per_object = 100 },
  apply = function(tray, params, out, store, frame)
    local entries = world["Electrical quantities"].objects
    local power = 0
    for _, entry in ipairs(entries) do
      local source = entry.object
      if source and source["Electrical device"] and source.Position then
        local distance = (source.Position.value - tray.Position.value):length()
        if distance <= params.heating then power = power + entry.power end
      end
    end
    local final = power / params.loss
    local left = math.exp(-frame.duration * params.loss / params.capacity)
    local warmer = final + (store.object.warmer - final) * left
    store.object.warmer = warmer
    if warmer < params.conducts then return end

    local within = {}
    for _, entry in ipairs(entries) do
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
