return interaction {
  name = "Dynamics <- Calm",
  text = "Nothing names it.",
  calls = "Dynamics",
  reads = { "Velocity" },
  attached = true,
  each = { "Velocity" },
  apply = function(object, params, out)
    out.addForce(object, object.Velocity.value * -1)
  end,
}
