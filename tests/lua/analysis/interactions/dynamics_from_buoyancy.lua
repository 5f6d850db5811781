return interaction {
  name = "Dynamics <- Buoyancy",
  text = "Applies F_B to each object at its centre of buoyancy.",
  calls = "Dynamics",
  reads = { "buoyancy_force", "centre_of_buoyancy", "Position", "Rotation" },
  once = true,
  apply = function(world, params, out)
    local centres = world.centre_of_buoyancy.centres
    for i, entry in ipairs(world.buoyancy_force.forces) do
      local object = entry.object
      if alive(object) and object.Position then
        local rotation = object.Rotation
        local point = object.Position.value + centres[i].centre:turned(rotation and rotation.value or 0)
        out.addForceToPoint(object, point, entry.force)
      end
    end
  end,
}
