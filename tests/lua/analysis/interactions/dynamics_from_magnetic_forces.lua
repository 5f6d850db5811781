return interaction {
  name = "Dynamics <- Magnetic Forces",
  text = "Adds all magnetic forces at the poles, or at the centre of what has none, and says how fast they vary.",
  calls = "Dynamics",
  reads = { "magnetic_force", "fixed" },
  once = true,
  apply = function(world, params, out)
    local force = world.magnetic_force
    for _, one in ipairs(force.rates) do
      if alive(one.object) then
        out.tellRate(one.object, one.rate, force.foreseen)
      end
    end
    for _, brake in ipairs(force.brakes) do
      if alive(brake.object) and not brake.object.fixed then
        out.addDrag(brake.object, brake.centre, 0, 0, 0, brake.angular)
      end
    end
    for _, entry in ipairs(force.forces) do
      if alive(entry.object) and not entry.object.fixed then
        out.addForceToPoint(entry.object, entry.point, entry.force)
      end
    end
  end,
}
