return interaction {
  name = "Buoyancy <- Gravity",
  text = "Feeds the world's linear gravity vector to buoyancy.",
  calls = "Buoyancy",
  reads = { "gravity" },
  each = { "gravity" },
  apply = function(object, params, out)
    out.setLinearGravity(object, object.gravity.value)
  end,
}
