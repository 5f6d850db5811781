return interaction {
  name = "Dynamics <- Gravity",
  text = "Applies the force due to gravity to each object at its centre of mass, unless it is fixed, and says how "
    .. "fast it varies.",
  calls = "Dynamics",
  reads = { "gravity_force", "fixed" },
  once = true,
  apply = function(world, params, out)
    for _, entry in ipairs(world.gravity_force.forces) do
      if alive(entry.object) and not entry.object.fixed then
        out.addForce(entry.object, entry.force)
        if entry.rate > 0 then
          out.tellRate(entry.object, entry.rate)
        end
      end
    end
  end,
}
