-- C++ reads from the graph whether it has connected a generator; a script keeps that itself.
local lettingGo = 0.9 -- of the speed: so that it does not flicker on the border

return interaction {
  name = "Electricity <- Rotation",
  text = "Connects every generator that turns fast enough to its source, and disconnects it when it turns a tenth "
    .. "slower than that.",
  calls = "Electricity",
  reads = { "generator", "Angular Velocity", "conductor" },
  each = { "generator" },
  store = { object = { connected = false } },
  apply = function(object, params, out, store)
    local source = object.generator.source
    if not object.conductor or not alive(source) or not source.conductor then
      store.object.connected = false
      return
    end
    local turning = object["Angular Velocity"]
    local speed = turning and math.abs(turning.value) or 0
    if not store.object.connected and speed >= object.generator.speed_deg then
      out.addConnection(object, source)
      store.object.connected = true
    elseif store.object.connected and speed < lettingGo * object.generator.speed_deg then
      out.removeConnection(object, source)
      store.object.connected = false
    end
  end,
}
