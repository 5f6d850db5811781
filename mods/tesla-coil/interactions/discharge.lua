-- Electrical discharges (7.3.2): "Two conductors placed close to each other will connect ... Moving the objects further
-- apart would maintain the connection until a cut-off point is reached. The connection could also be toggled in some
-- kind of pattern."
--
-- The connection is held: it lasts until this interaction's next turn, and a turn that does not ask for it again ends
-- it. So there is no list of connections to be taken back, and nothing is left over where an object has gone away.
local margin = 1e-9 -- s: sums of sixtieths of a second are not exact

local function sparksTo(coil, other)
  for _, connection in ipairs(coil["electricity_graph"].connections) do
    if same(connection.to, other) then
      for _, by in ipairs(connection.by) do
        if by.by == "Electricity <- Discharge" then return true end
      end
    end
  end
  return false
end

return interaction {
  name = "Electricity <- Discharge",
  text = "While current flows through it, a Tesla coil sparks for a moment in each of its periods. A spark connects it "
    .. "with all conductors nearby, and does not break off until they are farther away than it could begin.",
  calls = "Electricity",
  reads = { "Position", "Electrical state", "electricity_graph" },
  attached = true,
  each = { "Position", "electricity_graph" },
  restless = true, -- its clock goes on while nothing that it reads changes
  params = {
    period = { default = 2, min = 0.1, max = 60, unit = "s", text = "From the beginning of a spark to that of the next" },
    spark = { default = 0.5, min = 0, max = 60, unit = "s", text = "How long it connects" },
    reach = { default = 0.8, min = 0, max = 100, unit = "m", text = "Up to where a spark begins, from centre to centre" },
    cutoff = { default = 1.1, min = 0, max = 100, unit = "m", text = "Up to where it does not break off" },
  },
  store = { object = { clock = 0 } },
  limits = { instructions_per_object = 2000, calls_per_object = 100 },
  apply = function(coil, params, out, store, frame)
    local entries = world["Electrical state"].objects
    local on = false
    for _, entry in ipairs(entries) do
      on = on or (entry.on and same(entry.object, coil))
    end
    if not on then
      store.object.clock = 0
      return
    end
    local sparking = store.object.clock + margin < params.spark
    store.object.clock = store.object.clock + frame.duration
    if store.object.clock + margin >= params.period then
      store.object.clock = store.object.clock - params.period
    end
    if not sparking then return end
    for _, entry in ipairs(entries) do
      local other = entry.object
      if other and not same(other, coil) and other.Position then
        local distance = (other.Position.value - coil.Position.value):length()
        if distance <= params.reach or (distance <= params.cutoff and sparksTo(coil, other)) then
          out.holdConnection(coil, other)
        end
      end
    end
  end,
}
