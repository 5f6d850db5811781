return interaction { name = "Dynamics <- T", calls = "Dynamics", reads = { "Position", "Mass" }, each = { "Mass" },
  params = { k = { default = 2, min = 0, max = 9, unit = "N/m" } }, store = { object = { n = 0 } },
  apply = function(object, params, out, store, frame)
    store.object.n = store.object.n + frame.duration
    out.addForce(object, object.Position.value * -params.k)
  end }
