-- The shortest kind of interaction: for each pair that is near enough, a force that follows from what the two are now.
-- It leaves gravity alone and adds a force against it, so it works beside any other force, and its end needs no call.
return interaction {
  name = "Dynamics <- Anti-gravity",
  text = "Takes a share of its weight off every body whose centre is within a circle.",
  calls = "Dynamics",
  reads = { "Position", "Velocity", "Mass", "Gravity" },
  attached = true,
  pairs = { first = { "Position" }, second = { "Position", "Velocity", "Mass" }, within = "radius" },
  params = {
    radius = { default = 2, min = 0, max = 1000, unit = "m", text = "How far it reaches" },
    share = { default = 1, min = 0, max = 10, text = "1 takes off the whole weight; more lifts" },
  },
  apply = function(device, body, params, out)
    local gravity = world.Gravity -- nil in a level that states none
    if gravity then
      out.addForce(body, gravity.value * (-params.share * body.Mass.value))
    end
  end,
}
