return interaction {
  name = "Dynamics <- Breeze",
  text = "What is near a fan is blown along.",
  calls = "Dynamics",
  reads = { "Position", "Velocity" },
  attached = true,
  pairs = { first = { "Position" }, second = { "Position", "Velocity", "Mass" }, within = "reach" },
  params = {
    speed = { default = 8, min = 0, max = 60, unit = "m/s", text = "How hard it blows" },
    reach = { default = 6, min = 0, max = 1000, unit = "m", text = "How far it blows" },
    gusty = { default = false, text = "Whether it comes and goes" },
    along = { default = vec2(1, 0), text = "Which way it blows" },
    kind = { default = "warm", choices = { "warm", "cold" }, text = "What it feels like" },
  },
  store = { object = { turns = 0 } },
  apply = function(fan, body, params, out, store)
    store.object.turns = store.object.turns + 1
    if store.object.turns % 20 == 1 then
      log(params.kind, "for", store.object.turns, "turns")
    end
    if params.gusty and store.object.turns % 60 < 30 then
      return
    end
    out.addForce(body, params.along * (params.speed * 2))
  end,
}
